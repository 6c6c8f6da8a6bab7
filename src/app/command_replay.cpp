// SPDX-License-Identifier: MIT
#include "app/command_replay.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/streams.hpp"
#include "base/units.hpp"

namespace hackle {
namespace {

using ReplayJson = nlohmann::ordered_json;

std::string place_of(const Discrepancy& difference) {
  std::string text;
  if (difference.node)
    text =
        fmt::format(" of node ({}, {}) at {{{:.6g}, {:.6g}}} mm", difference.node->x(),
                    difference.node->y(), 1e3 * difference.place.x(), 1e3 * difference.place.y());
  return difference.detail.empty() ? text : fmt::format("{}, {}", text, difference.detail);
}

// What the hash says of a difference.
std::string verdict_on_hash(const Proof& proof) {
  if (!proof.has_hashes) return "the file has no hashes";
  if (proof.difference->quantity == "state_hash")
    return "all that is recorded of it is equal: the state differs by less than the file shows";
  return proof.exact_hash ? "the hash of its state agrees: the file has been changed since"
                          : "the hash of its state differs too";
}

std::string text_of_difference(const Proof& proof) {
  const Discrepancy& difference = *proof.difference;
  return fmt::format("record {} at {} (step {}) differs: {}{} is {} in the file, {} computed\n{}\n",
                     difference.record, quantity(difference.time, "s"), difference.step,
                     difference.quantity, place_of(difference), difference.recorded,
                     difference.computed, verdict_on_hash(proof));
}

ReplayJson json_of_difference(const Proof& proof) {
  const Discrepancy& difference = *proof.difference;
  ReplayJson json = {{"record", difference.record},    {"time_s", difference.time},
                     {"step", difference.step},        {"quantity", difference.quantity},
                     {"detail", difference.detail},    {"recorded", difference.recorded},
                     {"computed", difference.computed}};
  if (difference.node) {
    json["node"] = {static_cast<int>(difference.node->x()), static_cast<int>(difference.node->y())};
    json["place_m"] = {difference.place.x(), difference.place.y()};
  }
  if (proof.has_hashes) json["hash_agrees"] = proof.exact_hash;
  return json;
}

int code_of(const Proof& proof) {
  if (proof.difference) return static_cast<int>(ErrorKind::run_failed);
  if (proof.stopped.empty()) return 0;
  throw Error(ErrorKind::refused,
              fmt::format("replay: record {} is the first that cannot be computed: {}",
                          proof.compared, proof.stopped),
              "its script makes it again");
}

}  // namespace

std::string text_of(const Proof& proof, const std::string& run) {
  if (proof.difference) return fmt::format("{}: {}", run, text_of_difference(proof));
  const std::string which =
      proof.compared == proof.records
          ? fmt::format("all {} records agree", proof.records)
          : fmt::format("{} of {} records agree", proof.compared, proof.records);
  return fmt::format("{}: {}{}\n", run, which,
                     proof.has_hashes
                         ? ", to the last bit of the state"
                         : " in what they hold; the file is of a version without hashes");
}

ReplayJson to_json(const Proof& proof, const std::string& run) {
  ReplayJson json = {{"schema", 1},
                     {"run", run},
                     {"records", proof.records},
                     {"compared", proof.compared},
                     {"hashes", proof.has_hashes},
                     {"agrees", !proof.difference && proof.compared == proof.records}};
  if (proof.difference) json["difference"] = json_of_difference(proof);
  if (!proof.stopped.empty()) json["stopped"] = proof.stopped;
  return json;
}

int command_replay(const ReplayRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&] {
    const Proof proof = prove(request.run, request.execution, talk(request.quiet));
    if (request.json)
      print_out("{}\n", to_json(proof, request.run.string()).dump());
    else if (!request.quiet || proof.difference)
      print_out("{}", text_of(proof, request.run.string()));
    return code_of(proof);
  });
}

}  // namespace hackle
