#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How well simulate(p, { within = ... }) keeps its budget on the ready scenes, and what it costs.

usage: error_budget.py HACKLE FOLDER

Runs every scene in f32 with spacings of 1/2 to 1/12 of its horizon (of a fortieth of the shorter side
times 4 where the horizon follows from the spacing), and once more with another fifth digit of E; what
has been run is kept in FOLDER. Then replays the rule of src/study/budget.cpp, with the numbers of
assets/error_budget.json, for budgets of 1 to 3 horizons: is the error of what is chosen, the distance
of its crack paths from those of half the spacing, within the budget, and what does it cost over the
cheapest that is? The numbers were chosen on the scenes of CALIBRATION; OTHERS test them.
"""
import json
import math
import pathlib
import resource
import subprocess
import sys

STEPS = (2, 3, 4, 6, 8, 12)
BUDGETS = (1.0, 1.5, 2.0, 3.0)
PATIENCE = 45  # s of CPU time for a run; finer ones are left out
CALIBRATION = (
    "samples/centre_crack", "samples/edge_crack", "samples/hole", "benchmarks/mode_one",
    "benchmarks/inclusion", "gallery/two_holes", "benchmarks/soda_lime_ladder 2MPa",
    "benchmarks/soda_lime_ladder 4MPa", "gallery/photoelastic", "benchmarks/random_cracks")
OTHERS = (
    "benchmarks/kalthoff", "benchmarks/soda_lime_ladder 1MPa", "benchmarks/borden",
    "benchmarks/homalite", "gallery/own_picture", "gallery/heterogeneous",
    "benchmarks/soda_lime_ladder 0.2MPa", "samples/hole_and_crack", "samples/edge_crack_24mpa",
    "gallery/ring", "gallery/shatter", "gallery/quench")
ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(hackle, scene, settings, folder):
    name, *only = scene.split()
    words = ["prlimit", f"--cpu={PATIENCE}", hackle, "run", str(ROOT / f"scripts/{name}.lua"),
             "--json", "--bare", "--sample", "0", "--fresh", "-q", "--force", "--checkpoint", "0s",
             "-j", "1", "-o", str(folder / "out")]
    for key, value in {**({"only": only[0]} if only else {}), **settings}.items():
        words += ["--set", f"{key}={value}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run(words, capture_output=True, text=True, cwd=ROOT, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if ended.returncode != 0:
        return {"cpu": cpu}
    told = json.loads(ended.stdout)
    told = told["simulations"][-1] if "simulations" in told else told
    lines = [c["points_m"] for c in told["graph"]["cracks"] if not c["initial"] and c["points_m"]]
    return {"cpu": cpu, "lines": lines, "num": told["numerics"], "E": told["material"]["E_Pa"],
            "plate": [told["plate"]["width_m"], told["plate"]["height_m"]]}


def measured(hackle, scene, folder):
    kept = folder / (scene.split("/")[1].replace(" ", "_") + ".json")
    if kept.exists():
        return json.loads(kept.read_text())
    runs = {"own": run(hackle, scene, {}, folder)}
    horizon = runs["own"]["num"]["horizon_m"]
    for step in STEPS:
        spacing = horizon / step if horizon else min(runs["own"]["plate"]) / (10 * step)
        how = {"simulate.spacing": repr(spacing), "simulate.precision": "f32"}
        runs[f"m{step}"] = {**run(hackle, scene, how, folder), "spacing": spacing}
        if step <= 6:
            how["material.E"] = repr(runs["own"]["E"] * (1 + 1e-5))
            runs[f"c{step}"] = run(hackle, scene, how, folder)
        if "lines" not in runs[f"m{step}"] and runs[f"m{step}"]["cpu"] > 0.6 * PATIENCE:
            break
    kept.write_text(json.dumps(runs))
    return runs


def farthest(points, lines):
    pieces = [(line[k], line[min(k + 1, len(line) - 1)]) for line in lines for k in range(len(line))]
    worst = 0.0
    for x, y in (point for line in points for point in line):
        nearest = math.inf
        for (ax, ay), (bx, by) in pieces:
            dx, dy = bx - ax, by - ay
            square = dx * dx + dy * dy
            share = min(1.0, max(0.0, ((x - ax) * dx + (y - ay) * dy) / square)) if square else 0.0
            nearest = min(nearest, math.hypot(x - ax - share * dx, y - ay - share * dy))
            if nearest <= worst:
                break
        worst = max(worst, nearest)
    return worst


def distance(one, other):
    if not one or not other:
        return 0.0 if not one and not other else math.inf
    return max(farthest(one, other), farthest(other, one))


class Scene:
    def __init__(self, runs):
        self.given = runs["own"]["num"]["horizon_m"]
        self.unit = self.given or min(runs["own"]["plate"]) / 10
        self.lines = {s: runs[f"m{s}"]["lines"] for s in STEPS if "lines" in runs.get(f"m{s}", {})}
        self.cpu = {s: runs[f"m{s}"]["cpu"] for s in self.lines}
        self.spacing = {s: runs[f"m{s}"]["spacing"] for s in self.lines}
        self.error = {s: distance(line, self.lines[2 * s]) for s, line in self.lines.items()
                      if 2 * s in self.lines}
        self.chaos = {s: distance(self.lines[s], runs[f"c{s}"]["lines"]) for s in self.lines
                      if "lines" in runs.get(f"c{s}", {})}

    # The rule of src/study/budget.cpp: a spacing, and the error that is expected, if any.
    def choose(self, within, numbers):
        levels = [s for s in STEPS if s <= 8 and s in self.lines]

        def least(step):
            return numbers["least_horizons"] * (self.given or 4 * self.spacing[step])

        for coarse, fine in zip(levels, levels[1:]):
            apart = distance(self.lines[coarse], self.lines[fine])
            for step, factor in ((coarse, "of_coarser"), (fine, "of_same")):
                expected = max(numbers[factor] * apart, least(step))
                if self.lines[step] and expected <= within:
                    chaotic = self.chaos.get(coarse, self.chaos.get(step, 0.0)) > within
                    return step, None if chaotic else expected
        return levels[-1], None


def judged(scenes, numbers):
    promised = kept = dear = compared = untold = 0
    for name, scene in scenes.items():
        for budget in BUDGETS:
            within = budget * scene.unit
            step, expected = scene.choose(within, numbers)
            fit = [s for s in scene.error if scene.lines[s] and scene.error[s] <= within]
            error = scene.error.get(step)
            cost = scene.cpu[step] / scene.cpu[fit[0]] if fit else None
            told = "none" if expected is None else f"{1e3 * expected:.2f}"
            got = "?" if error is None else f"{1e3 * error:.2f}"
            print(f"{name:34s} {1e3 * within:6.2f} {step:2d} {told:>6s} {got:>6s}  "
                  f"{fit[0] if fit else 'none':>4}  {'-' if cost is None else f'{cost:.1f}'}")
            if expected is not None and cost is not None:
                compared += 1
                dear += cost > 2.05
            if expected is None or error is None:
                untold += 1
                continue
            promised += 1
            kept += error <= within
    print(f"promised and checked {promised}, kept {kept}; over twice the cheapest {dear} of "
          f"{compared}; {untold} not promised, or too dear to check\n")


def main():
    hackle, folder = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    numbers = json.loads((ROOT / "assets/error_budget.json").read_text())
    for title, names in (("calibration", CALIBRATION), ("others", OTHERS)):
        print(f"{title:34s} within  m expect measured  cheapest m  cost    (mm)")
        scenes = {name: Scene(measured(hackle, name, folder)) for name in names}
        judged({name: one for name, one in scenes.items() if one.lines}, numbers)


if __name__ == "__main__":
    main()
