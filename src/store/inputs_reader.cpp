// SPDX-License-Identifier: MIT
#include "store/inputs_reader.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "store/noun_reader.hpp"

namespace hackle {
namespace {

using Json = NounReader::Json;

constexpr int max_depth = 16;
// Sixteen bytes per value, from a text with at least two per value; of a crack nine.
constexpr std::int64_t max_values = 8'000'000;

void stop_if_interrupted() {
  if (interrupted())
    throw Error(ErrorKind::interrupted, "interrupted while the inputs of a run were read");
}

// Refuses a text that is nested more deeply, or has more values, than any from inputs_of(), before
// it takes memory.
class Bounds {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json&) {
    if (depth > max_depth) refuse_inputs("it goes too deep");
    if (event == Json::parse_event_t::object_end || event == Json::parse_event_t::array_end)
      return true;
    if (++values_ > max_values)
      refuse_inputs(fmt::format("it holds more than {} values", max_values));
    constexpr std::int64_t now_and_then = 4096;
    if (values_ % now_and_then == 0) stop_if_interrupted();
    return true;
  }

 private:
  std::int64_t values_ = 0;
};

}  // namespace

Inputs read_inputs(const std::string& text) {
  try {
    const Json json = Json::parse(text, Bounds());
    Inputs inputs;
    NounReader reader;
    reader.read(json.at("plate"), inputs.plate);
    reader.read(json.at("numerics"), inputs.numerics);
    return inputs;
  } catch (const Json::parse_error& error) {  // its message quotes the text
    refuse_inputs(fmt::format("it is no JSON at byte {}", error.byte));
  } catch (const Json::out_of_range&) {
    refuse_inputs("something is missing or too large");
  } catch (const Json::exception&) {
    refuse_inputs("something is of another type");
  }
}

}  // namespace hackle
