// SPDX-License-Identifier: MIT
#include "store/inputs.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "store/noun_writer.hpp"

namespace hackle {
namespace {

using Json = NounWriter::Json;

// Replaces defaults by the values of the run.
Json resolved(const Simulation& simulation) {
  const Lattice& lattice = simulation.lattice();
  Numerics numerics = simulation.numerics();
  numerics.horizon = numerics.horizon_or_default();
  Json json = NounWriter::json_of(numerics);
  json["asked_step_s"] = json["step_s"];
  json["step_s"] = simulation.dt();
  json.update({{"nx", lattice.grid.nx},
               {"ny", lattice.grid.ny},
               {"micromodulus_N_m6", lattice.calibration.c},
               {"critical_stretch", lattice.calibration.s0},
               {"step_limit_s", lattice.step_limit}});
  return json;
}

std::string text_of(const Plate& plate, Json numerics) {
  const Json inputs = {{"plate", NounWriter::json_of(plate)}, {"numerics", std::move(numerics)}};
  // The name of a material may contain invalid UTF-8.
  return inputs.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string inputs_of(const Simulation& simulation) {
  return text_of(simulation.plate(), resolved(simulation));
}

std::string inputs_of(const Plate& plate, const Numerics& numerics) {
  return text_of(plate, NounWriter::json_of(numerics));
}

}  // namespace hackle
