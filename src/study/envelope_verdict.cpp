// SPDX-License-Identifier: MIT
#include "study/envelope_verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <regex>

#include <fmt/format.h>

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double most_residual = 0.05;
constexpr int run_failed = 1, script_error = 3, refused_input = 4, signalled = 128;

CellVerdict failure(std::string why) {
  return {CellEnd::failed, std::move(why)};
}

bool has_text(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// What may be missing: bounds of an expectation that has others, and samples in holes.
bool may_be_null(const std::string& key) {
  constexpr std::array<std::string_view, 5> keys{"expected", "tolerance", "min", "max", "sample"};
  return std::ranges::find(keys, key) != keys.end();
}

// Returns the place of a number that is not finite, which JSON writes as null, or nothing.
std::optional<std::string> not_a_number(const Json& json, const std::string& place = "") {
  if (json.is_null()) return place;
  if (json.is_number_float() && !std::isfinite(json.get<double>())) return place;
  if (json.is_object())
    for (const auto& [key, value] : json.items())
      if (!may_be_null(key))
        if (auto found =
                not_a_number(value, place.empty() ? key : fmt::format("{}.{}", place, key)))
          return found;
  if (json.is_array())
    for (const Json& value : json)
      if (auto found = not_a_number(value, place)) return found;
  return std::nullopt;
}

bool says_nan(const std::string& text) {
  static const std::regex words(R"((^|[^A-Za-z_])-?(nan|inf)([^A-Za-z_]|$))");
  return std::regex_search(text, words);
}

// The simulations of a run, or the one there is.
Json simulations_in(const Json& told) {
  return told.contains("simulations") ? told["simulations"] : Json::array({told});
}

bool says_that_energy_is_lost(const Json& simulation) {
  for (const Json& note : simulation.value("notes", Json::array()))
    if (has_text(note.get<std::string>(), "the energies do not add up")) return true;
  return false;
}

std::optional<std::string> unsaid_residual(const Json& told) {
  for (const Json& one : simulations_in(told)) {
    const double share = std::abs(one.value("residual_share", 0.0));
    if (share > most_residual && !says_that_energy_is_lost(one))
      return fmt::format("{:.3g} % of the energy is missing, and no note says so", 100.0 * share);
  }
  return std::nullopt;
}

std::optional<std::string> failed_expectation(const Json& expectations) {
  for (const Json& one : expectations)
    if (one.value("verdict", "fail") != "pass")
      return fmt::format("{}: {}, not {} within {} ({})", one.value("quantity", ""),
                         one.value("got", Json()).dump(), one.value("expected", Json()).dump(),
                         one.value("tolerance", Json()).dump(), one.value("source", ""));
  return std::nullopt;
}

CellVerdict of_result(const Json& told) {
  if (!told.is_object()) return failure("it printed no JSON object");
  const Json expectations = told.value("expectations", Json::array());
  if (auto wrong = failed_expectation(expectations)) return failure(*std::move(wrong));
  if (auto place = not_a_number(told)) return failure(*place + " is no finite number");
  if (says_nan(told.dump(-1, ' ', false, Json::error_handler_t::replace)))
    return failure("its output has a nan or inf");
  if (auto lost = unsaid_residual(told)) return failure(*std::move(lost));
  if (expectations.empty()) return failure("it checks nothing");
  return {CellEnd::right, fmt::format("{} checks pass", expectations.size())};
}

// Returns the number of the time after "at" or "at t =", in its own unit.
std::optional<double> time_in(const std::string& message) {
  static const std::regex time(R"(at (t = )?([0-9][0-9.e+-]*) ([a-z]?s)\b)");
  std::smatch found;
  if (!std::regex_search(message, found, time)) return std::nullopt;
  return std::strtod(found[2].str().c_str(), nullptr);
}

bool names_a_place(const std::string& message) {
  static const std::regex place(R"(\([^()]*m, [^()]*m\)|\.lua:[0-9]+)");
  return std::regex_search(message, place);
}

// The words by which messages say what would be right.
bool has_remedy(const std::string& message) {
  constexpr std::array<std::string_view, 6> ways{"(",    "expected", "must",
                                                 "give", "at least", "between"};
  for (const std::string_view way : ways)
    if (has_text(message, way)) return true;
  return false;
}

// An error of the script itself is told with its line, which is what to mend.
CellVerdict of_error(const Outcome& outcome) {
  const std::string& message = outcome.reason;
  const bool before = outcome.exit_code != run_failed && time_in(message).value_or(0.0) == 0.0;
  const bool own = outcome.exit_code == script_error && names_a_place(message);
  if (before && !own && !has_remedy(message))
    return failure("the refusal has no remedy: " + message);
  if (before) return {CellEnd::refused, message};
  if (outcome.exit_code == run_failed && says_nan(message))
    return failure("the message has a nan or inf: " + message);
  if (!time_in(message) || !names_a_place(message))
    return failure("the stop does not name time and place: " + message);
  return {CellEnd::stopped, message};
}

CellVerdict of_end(const Outcome& outcome) {
  switch (outcome.exit_code) {
    case 0:
      return of_result(outcome.told);
    case run_failed:
    case script_error:
    case refused_input:
      return of_error(outcome);
    default:
      break;
  }
  if (outcome.exit_code > signalled)
    return failure(fmt::format("signal {} ended it", outcome.exit_code - signalled));
  return failure(fmt::format("exit code {}: {}", outcome.exit_code, outcome.reason));
}

bool allows(Demand demand, CellEnd end) {
  switch (demand) {
    case Demand::right:
      return end == CellEnd::right;
    case Demand::refused:
      return end == CellEnd::refused;
    case Demand::stopped:
      return end == CellEnd::stopped;
    case Demand::unlike:
      return end == CellEnd::refused || end == CellEnd::stopped;
    case Demand::any:
      return true;
  }
  return false;
}

std::string_view wish_of(Demand demand) {
  switch (demand) {
    case Demand::refused:
      return "a refusal";
    case Demand::stopped:
      return "a stop";
    case Demand::unlike:
      return "a refusal or a stop";
    default:
      return "a right result";
  }
}

}  // namespace

CellVerdict verdict_of(const Outcome& outcome, Demand demand) {
  if (outcome.state == CaseState::stopped)
    return failure(fmt::format("it hangs, or is too slow: {}", outcome.reason));
  CellVerdict verdict = of_end(outcome);
  if (verdict.end == CellEnd::failed || allows(demand, verdict.end)) return verdict;
  return failure(fmt::format("it is {}, and {} is due: {}", name_of(verdict.end), wish_of(demand),
                             verdict.why));
}

}  // namespace hackle
