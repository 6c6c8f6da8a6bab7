// SPDX-License-Identifier: MIT
#include "store/journal.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "store/noun_reader.hpp"
#include "store/noun_writer.hpp"

namespace hackle {
namespace {

using DeedJson = NounWriter::Json;

// Between two records: a script that changes loads in every step of a long run needs more records.
constexpr std::size_t max_deeds = 10'000;
constexpr std::size_t max_journal_bytes = std::size_t{1} << 24U;

// The name of a material may contain invalid UTF-8.
std::string dumped(const DeedJson& json) {
  return json.dump(-1, ' ', false, DeedJson::error_handler_t::replace);
}

std::string deed_text(const char* name, std::int64_t step, int look, const DeedJson& more) {
  DeedJson json = {{"did", name}, {"step", step}};
  if (look >= 0) json["look"] = look;
  json.update(more);
  return dumped(json);
}

// Whether it can be the name of a member: no other word of a file is repeated.
bool is_member_name(std::string_view key) {
  constexpr std::size_t longest = 24;
  return key.size() <= longest &&
         key.find_first_not_of("abcdefghijklmnopqrstuvwxyzKNP0123456789_") ==
             std::string_view::npos;
}

// Adds the places below this one that hold a function, as NounWriter::function_of() writes it.
void find_functions(const DeedJson& json, const std::string& place,
                    std::vector<std::string>& found) {
  const auto deeper = [&](const std::string& key) {
    const std::string part = is_member_name(key) ? key : "something";
    return place.empty() ? part : fmt::format("{} {}", place, part);
  };
  if (json.is_object() && json.size() == 1 && json.contains("function")) {
    found.push_back(place);
  } else if (json.is_object()) {
    for (const auto& [key, value] : json.items()) find_functions(value, deeper(key), found);
  } else if (json.is_array()) {
    int number = 0;
    for (const DeedJson& entry : json)
      if (++number; entry.is_structured())
        find_functions(entry, deeper(std::to_string(number)), found);
  }
}

std::string loads_text(const Simulation& simulation, int look) {
  return deed_text("loads", simulation.state().step, look,
                   {{"loads", NounWriter::json_of(simulation.plate().loads)}});
}

double finite_number(const DeedJson& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw std::invalid_argument("not finite");
  return value;
}

ChangedLoads changed_loads(const DeedJson& json) {
  ChangedLoads changed;
  NounReader().read(json.at("loads"), changed.loads);
  find_functions(json.at("loads"), "", changed.functions);
  return changed;
}

LoadedSlowly loaded_slowly(const DeedJson& json) {
  constexpr int max_increments = 1'000'000'000;
  const LoadedSlowly loading{finite_number(json.at("end_s")), json.at("increments").get<int>(),
                             finite_number(json.at("tolerance"))};
  if (loading.increments < 1 || loading.increments > max_increments)
    throw std::invalid_argument("increments");
  return loading;
}

Deed deed_in(const DeedJson& json) {
  Deed deed;
  deed.step = json.at("step").get<std::int64_t>();
  if (deed.step < 0) throw std::invalid_argument("step");
  if (json.contains("look")) deed.look = json.at("look").get<int>();
  const std::string& name = json.at("did").get_ref<const std::string&>();
  if (name == "loads")
    deed.what = changed_loads(json);
  else if (name == "relax")
    deed.what = CameToRest{finite_number(json.at("tolerance"))};
  else if (name == "quasistatic")
    deed.what = loaded_slowly(json);
  else if (name == "end")
    deed.what = EndedSlowly{json.at("looks").get<int>()};
  else if (name == "record")
    deed.what = Recorded{};
  else
    deed.what = NotNoted{};
  return deed;
}

}  // namespace

void Journal::add(const Simulation& simulation, std::string deed) {
  if (full_) return;
  bytes_ += deed.size();
  if (deeds_.size() >= max_deeds || bytes_ > max_journal_bytes) return lose_track(simulation);
  deeds_.push_back(std::move(deed));
}

void Journal::lose_track(const Simulation& simulation) {
  full_ = true;
  deeds_ = {deed_text("too much", simulation.state().step, -1, DeedJson::object())};
}

void Journal::changed_loads(const Simulation& simulation) {
  add(simulation, loads_text(simulation, look_));
}

void Journal::came_to_rest(const Simulation& simulation, double tolerance) {
  add(simulation, deed_text("relax", simulation.state().step, -1, {{"tolerance", tolerance}}));
}

void Journal::loads_slowly(const Simulation& simulation, const LoadedSlowly& loading) {
  slow_ = deed_text("quasistatic", simulation.state().step, -1,
                    {{"end_s", loading.end},
                     {"increments", loading.increments},
                     {"tolerance", loading.tolerance}});
  add(simulation, slow_);
}

void Journal::ended_slowly(const Simulation& simulation) {
  add(simulation, deed_text("end", simulation.state().step, -1, {{"looks", look_ + 1}}));
  slow_.clear();
  look_ = -1;
}

void Journal::begin() {
  deeds_.clear();
  bytes_ = 0;
  full_ = false;
  if (!slow_.empty()) deeds_.push_back(slow_);
}

std::string Journal::pending() const {
  std::string text;
  for (const std::string& deed : deeds_) text += (text.empty() ? "[" : ",\n ") + deed;
  return text.empty() ? text : text + "]\n";
}

void Journal::resume(const std::string& pending) {
  *this = Journal();
  if (pending.empty()) return;
  for (const DeedJson& deed : DeedJson::parse(pending)) {
    deeds_.push_back(dumped(deed));
    bytes_ += deeds_.back().size();
    full_ = deed.at("did") == "too much";
  }
}

std::string Journal::take(const Simulation& simulation) {
  if (full_) deeds_.push_back(loads_text(simulation, -1));
  std::string text;
  for (const std::string& deed : deeds_) text += (text.empty() ? "[" : ",\n ") + deed;
  if (look_ >= 0)
    text += (text.empty() ? "[" : ",\n ") +
            deed_text("record", simulation.state().step, look_, DeedJson::object());
  if (!text.empty()) text += "]\n";
  deeds_.clear();
  bytes_ = 0;
  full_ = false;
  return text;
}

std::vector<Deed> deeds_in(const std::string& text) {
  std::vector<Deed> deeds;
  if (text.empty()) return deeds;
  for (const DeedJson& json : DeedJson::parse(text)) deeds.push_back(deed_in(json));
  return deeds;
}

std::vector<std::string> functions_in(const std::string& inputs) {
  std::vector<std::string> found;
  DeedJson plate = DeedJson::parse(inputs).at("plate");
  plate.erase("starts");  // the first record holds what comes of it
  find_functions(plate, "", found);
  return found;
}

}  // namespace hackle
