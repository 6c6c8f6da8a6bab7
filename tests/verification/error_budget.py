#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How well simulate(p, { within = ... }) keeps its budget on the ready scenes, and what it costs.

usage: error_budget.py HACKLE [SHARE]   (the budget in horizons, 1 if not given)

For each scene whose horizon is fixed: the spacing that the budget chooses, the error it expects,
and the measured error, which is the distance of the crack paths from those of half the spacing.
The other spacings down to the chosen one are measured in the same way; the cheapest that keeps the
budget is what the choice is compared with, in CPU time.
"""
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

STEPS = (2, 3, 4, 6, 8)
SCENES = (
    ("samples/edge_crack.lua", {}), ("samples/centre_crack.lua", {}), ("samples/hole.lua", {}),
    ("samples/edge_crack_24mpa.lua", {"spacing": "0.25mm", "horizon": "1mm"}),
    ("benchmarks/inclusion.lua", {}), ("benchmarks/kalthoff.lua", {}),
    ("benchmarks/soda_lime_ladder.lua", {"only": "2MPa"}), ("benchmarks/borden.lua", {}),
    ("benchmarks/homalite.lua", {}), ("gallery/two_holes.lua", {}),
    ("benchmarks/random_cracks.lua", {}), ("gallery/heterogeneous.lua", {}),
)
ROOT = pathlib.Path(__file__).resolve().parents[2] / "scripts"


def run(hackle, scene, settings, folder):
    words = [hackle, "run", str(ROOT / scene), "--json", "--bare", "--sample", "0", "--fresh", "-q",
             "--force", "--checkpoint", "0s", "-o", str(folder / "out")]
    for key, value in settings.items():
        words += ["--set", f"{key}={value}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run(words, capture_output=True, text=True, cwd=folder, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if ended.returncode != 0:
        raise RuntimeError(f"{scene} {settings}: {ended.stderr}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads(ended.stdout), cpu


def lines_of(told):
    return [c["points_m"] for c in told["graph"]["cracks"] if not c["initial"] and c["points_m"]]


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


def figures(hackle, scene, settings, share, folder):
    own, _ = run(hackle, scene, settings, folder)
    horizon = own["numerics"]["horizon_m"]
    within = share * horizon
    asked = {"simulate.spacing": "default", "simulate.within": repr(within)}
    budget, chosen_at = run(hackle, scene, {**settings, **asked}, folder)[0]["budget"], None
    runs = {}

    def at(step, precision):
        if (step, precision) not in runs:
            how = {"simulate.spacing": repr(horizon / step), "simulate.precision": precision}
            told, cpu = run(hackle, scene, {**settings, **how}, folder)
            runs[step, precision] = (lines_of(told), cpu)
        return runs[step, precision]

    cheapest = None
    for step in STEPS:
        error = distance(at(step, "f32")[0], at(2 * step, "f32")[0])
        if cheapest is None and error <= within:
            cheapest = step
        if abs(horizon / step - budget["spacing_m"]) < 1e-9:
            chosen_at = step
            break
    cost = at(chosen_at, "f32")[1] / at(cheapest, "f32")[1] if cheapest else None
    return budget, within, horizon, chosen_at, error, cheapest, cost


def main():
    share = float(sys.argv[2]) if len(sys.argv) > 2 else 1.0
    print("scene                 within   m  expected  measured  kept  cheapest m  cost  chaotic")
    with tempfile.TemporaryDirectory() as name:
        for scene, settings in SCENES:
            found = figures(str(pathlib.Path(sys.argv[1]).resolve()), scene, settings, share,
                            pathlib.Path(name))
            budget, within, _, step, error, cheapest, cost = found
            expected = budget["expected_m"]
            print(f"{pathlib.Path(scene).stem:20s}  {1e3 * within:6.2f}  {step:2d}  "
                  f"{'none' if expected is None else f'{1e3 * expected:.2f}':>8s}  "
                  f"{1e3 * error:8.2f}  {'yes' if error <= within else 'no':>4s}  "
                  f"{cheapest or 'none':>10}  {'-' if cost is None else f'{cost:.1f}':>4s}  "
                  f"{'yes' if budget['chaotic'] else 'no'}", flush=True)


if __name__ == "__main__":
    main()
