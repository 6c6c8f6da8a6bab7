// SPDX-License-Identifier: MIT
// Answers `hackle run SCRIPT --json --sample T --set key=value ...` without any physics: a crack
// that forks at (fork + a dx^p, 0.02), so that the errors of a study are known. The script is a
// JSON object with the numbers; `fails` names a key whose being set makes the run fail.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

using Json = nlohmann::ordered_json;

namespace {

std::map<std::string, std::string> set;

double number(const std::string& key, double fallback) {
  const auto at = set.find(key);
  return at == set.end() || at->second == "default" ? fallback
                                                    : std::strtod(at->second.c_str(), nullptr);
}

std::string text(const std::string& key, const std::string& fallback) {
  const auto at = set.find(key);
  return at == set.end() ? fallback : at->second;
}

Json piece(double x0, double x1, double y) {
  Json points = Json::array(), times = Json::array();
  for (int k = 0; k <= 20; ++k) {
    points.push_back({x0 + (x1 - x0) * k / 20, y});
    times.push_back(1e-6 * k);
  }
  return {{"parent", -1},
          {"initial", false},
          {"length_m", std::abs(x1 - x0)},
          {"points_m", points},
          {"times_s", times}};
}

}  // namespace

int main(int count, char** words) {
  const std::string script = words[2];
  for (int k = 3; k + 1 < count; ++k)
    if (std::string(words[k]) == "--set") {
      const std::string setting = words[k + 1];
      set[setting.substr(0, setting.find('='))] = setting.substr(setting.find('=') + 1);
    }
  std::ifstream file(script);
  const Json model = Json::parse(file);
  std::ofstream(script + ".calls", std::ios::app) << "run\n";
  if (set.contains(model.value("fails", std::string("none")))) {
    std::cerr << "error: this cannot be (do otherwise)\n";
    return 4;
  }
  const double dx = number("simulate.spacing", model.value("spacing", 1e-3));
  const double horizon = number("simulate.horizon", model.value("horizon", 4e-3));
  const double safety = number("simulate.safety", 0.9);
  const double error = model.value("a", 1.0) * std::pow(dx, model.value("p", 1.0));
  const double chaos = model.value("chaos", 0.0) * number("material.E", 65e9);
  const double bits = model.value("bits", 0.0) * (number("material.E", 65e9) - 65e9);
  const double fork = model.value("fork", 0.06) + error + chaos + bits +
                      model.value("valleys", 0.0) * std::abs(number("material.E", 65e9));
  const double speed = 1000.0;
  Json told{{"schema", 1},
            {"nodes", std::lround(0.004 / (dx * dx))},
            {"time_s", 1e-4},
            {"dt_s", safety * 1e-7},
            {"dt_limit_s", 1e-7},
            {"node_steps_per_s", 1e7},
            {"residual_share", 1e-3 * safety}};
  told["numerics"] = {{"spacing_m", dx},
                      {"horizon_m", horizon},
                      {"precision", text("simulate.precision", "f64")},
                      {"fused", false},
                      {"fidelity", number("simulate.fidelity", 0.0)},
                      {"quadrature", text("simulate.quadrature", "full")},
                      {"micromodulus", "constant"},
                      {"constants", "lattice"},
                      {"breaking", "at_once"},
                      {"surface", text("simulate.surface", "none")},
                      {"safety", safety},
                      {"step_s", "default"}};
  told["material"] = {{"E_Pa", number("material.E", 65e9)}, {"alpha", 0.0}};
  told["energy_J_per_m"] = {{"broken", 2.0 + error}};
  told["first_break"] = {{"time_s", 1e-5}, {"place_m", {0.05, 0.02}}};
  told["events"] = {{{"kind", "branch"},
                     {"time_s", (fork - 0.05) / speed},
                     {"place_m", {fork, 0.02}},
                     {"angle_rad", 1.0}}};
  told["graph"] = {{"cracks", {piece(0.05, fork, 0.02)}}, {"tips", {{{"state", "running"}}}}};
  told["sample"] = {{"displacements_m", {{1.0 + error, 0.0}, nullptr, {0.0, 1.0}}}};
  told["elastic"] = {{"stiffness_Pa", 70e9 * (1.0 - error)},
                     {"wavelength_m", 8e-3},
                     {"wave_speed_m_per_s", 5000.0 * (1.0 - 2.0 * error)}};
  told["plate"] = {{"width_m", 0.1}, {"height_m", 0.04}, {"rows", Json::array()}};
  told["files"] = Json::array();
  if (model.contains("movie")) told["files"].push_back(model["movie"]);
  std::cout << told.dump() << "\n";
}
