// SPDX-License-Identifier: MIT
#include "store/inputs_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/text.hpp"
#include "store/json_key.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

constexpr int max_depth = 16;
// Sixteen bytes per value, from a text with at least two per value; of a crack nine.
constexpr std::int64_t max_values = 8'000'000;
// of a picture, the limit when it is read
constexpr std::int64_t max_cells = std::int64_t{1} << 24;
constexpr std::int64_t max_cells_in_all = 4 * max_cells;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::files, "the inputs of the run cannot be read: " + what);
}

void stop_if_interrupted() {
  if (interrupted())
    throw Error(ErrorKind::interrupted, "interrupted while the inputs of a run were read");
}

bool is_function(const Json& json) {
  return json.is_object() || json == "function";
}

[[noreturn]] void refuse_function() {
  throw Error(ErrorKind::files, "functions of a script are not in its run file",
              "run the script again");
}

// Returns the numbers of "12 3 40".
std::vector<std::int64_t> lengths_in(const std::string& text) {
  std::vector<std::int64_t> list;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end; ++at) {
    std::int64_t length = 0;
    const auto [rest, failure] = std::from_chars(at, end, length);
    if (failure != std::errc() || (rest != end && *rest != ' ')) refuse("a picture is no picture");
    list.push_back(length);
    at = rest;
  }
  return list;
}

// Counts the cells of all pictures.
class Cells {
 public:
  // Reads the cells from run lengths, outside first; these are a text or a list.
  std::vector<std::uint8_t> read(const Json& run_lengths, std::int64_t count) {
    if (count < 0 || count > max_cells) refuse("a picture is too large");
    if ((all_ += count) > max_cells_in_all) refuse("its pictures are too many");
    stop_if_interrupted();
    const auto lengths = run_lengths.is_string()
                             ? lengths_in(run_lengths.get_ref<const std::string&>())
                             : run_lengths.get<std::vector<std::int64_t>>();
    return cells(lengths, count);
  }

 private:
  static std::vector<std::uint8_t> cells(const std::vector<std::int64_t>& lengths,
                                         std::int64_t count) {
    std::vector<std::uint8_t> list;
    std::uint8_t value = 0;
    for (const std::int64_t length : lengths) {
      const auto room = count - static_cast<std::int64_t>(list.size());
      if (length < 0 || length > room) refuse("a picture has too many cells");
      list.insert(list.end(), static_cast<std::size_t>(length), value);
      value = value == 0 ? 1 : 0;
    }
    if (static_cast<std::int64_t>(list.size()) != count) refuse("a picture has too few cells");
    return list;
  }

  std::int64_t all_ = 0;
};

// Reads the text of inputs.cpp member by member. A member that an older file lacks keeps its
// default, unless it is required.
class Reader {
 public:
  template <Described Noun>
  void read(const Json& json, Noun& noun) {
    if (!json.is_object()) refuse("something is of another type");
    for_each_member<Noun>([&](const auto& member) {
      auto& value = noun.*member.pointer;
      if constexpr (requires { member.kind; })
        read_kind(json, noun.*member.kind, value, member);
      else if constexpr (requires { read(json, value); })
        member.name.empty() ? read(json, value) : read_named(json, value, member);
      else
        read_named(json, value, member);
    });
  }

 private:
  template <class T, class MemberOfT>
  void read_named(const Json& json, T& value, const MemberOfT& member) {
    const std::string key = key_of(member.name, member.about.unit);
    if (json.contains(key))
      read_value(json.at(key), value, member.name);
    else if (member.about.required)
      refuse("something is missing or too large");
  }

  template <class Kind, class T, class MemberOfT>
  void read_kind(const Json& json, Kind& kind, T& value, const MemberOfT& member) {
    for (std::size_t k = 0; k < member.names.size(); ++k) {
      const std::string key = key_of(member.names[k], member.abouts[k].unit);
      if (!json.contains(key)) continue;
      kind = static_cast<Kind>(k);
      return read_value(json.at(key), value, member.names[k]);
    }
    refuse("something is missing or too large");
  }

  template <class T>
  void read_value(const Json& json, T& value, std::string_view name) {
    if constexpr (std::is_enum_v<T>) {
      const std::optional<T> found = value_named<T>(json.get_ref<const std::string&>());
      if (!found) refuse(fmt::format("{} is none of {}", name, comma_list(enum_names<T>)));
      value = *found;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      value = json.get<T>();
    } else {
      read(json, value);
    }
  }

  void read(const Json& json, Vec2& vector) {
    vector = {json.at(0).get<double>(), json.at(1).get<double>()};
  }

  void read(const Json& json, VectorField& field) {
    Vec2 constant{0, 0};
    if (is_function(json))
      field = VectorField([](const Vec2&) -> Vec2 { refuse_function(); });
    else
      read(json, constant), field = constant;
  }

  void read(const Json& json, ScalarField& field) {
    if (is_function(json))
      field = ScalarField([](const Vec2&) -> double { refuse_function(); });
    else
      field = json.get<double>();
  }

  void read(const Json& json, Amplitude& amplitude) {
    if (json == "constant") return;
    if (json.is_array()) {
      std::vector<Vec2> points;
      read(json, points);
      amplitude = Amplitude(std::move(points));
    } else {
      const Json& text = json.is_object() ? json.at("function") : json;
      amplitude = Amplitude([](double) -> double { refuse_function(); }, text.get<std::string>());
    }
  }

  template <class T>
  void read(const Json& json, std::vector<T>& list) {
    for (const Json& entry : json) read(entry, list.emplace_back());
  }

  // A word stands for an empty optional.
  template <class T>
  void read(const Json& json, std::optional<T>& value) {
    if (!json.is_string()) read_value(json, value.emplace(), "");
  }

  template <std::size_t... kinds>
  static std::string kinds_of_shapes(std::index_sequence<kinds...>) {
    return comma_list(std::array{description_of<std::variant_alternative_t<kinds, Shape>>.noun...});
  }

  void read(const Json& json, Shape& shape) { read_shape<0>(json, shape); }

  template <std::size_t kind>
  void read_shape(const Json& json, Shape& shape) {
    if constexpr (kind == std::variant_size_v<Shape>) {
      refuse("a shape is none of " + kinds_of_shapes(std::make_index_sequence<kind>()));
    } else {
      using Kind = std::variant_alternative_t<kind, Shape>;
      if (json.at("kind").get_ref<const std::string&>() != description_of<Kind>.noun)
        return read_shape<kind + 1>(json, shape);
      read(json, shape.emplace<Kind>());
    }
  }

  void read(const Json& json, Bitmap& bitmap) {
    read(json.at("from_m"), bitmap.least);
    read(json.at("to_m"), bitmap.most);
    bitmap.columns = json.at("columns").get<int>();
    bitmap.rows = json.at("rows").get<int>();
    if (bitmap.columns < 1 || bitmap.rows < 1) refuse("a picture has no cells");
    bitmap.inside = cells_.read(json.at("run_lengths"), std::int64_t{bitmap.columns} * bitmap.rows);
  }

  Cells cells_;
};

// Refuses a text that is nested more deeply, or has more values, than any from inputs_of(), before
// it takes memory.
class Bounds {
 public:
  bool operator()(int depth, Json::parse_event_t event, Json&) {
    if (depth > max_depth) refuse("it goes too deep");
    if (event == Json::parse_event_t::object_end || event == Json::parse_event_t::array_end)
      return true;
    if (++values_ > max_values) refuse(fmt::format("it holds more than {} values", max_values));
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
    Reader reader;
    reader.read(json.at("plate"), inputs.plate);
    reader.read(json.at("numerics"), inputs.numerics);
    return inputs;
  } catch (const Json::parse_error& error) {  // its message quotes the text
    refuse(fmt::format("it is no JSON at byte {}", error.byte));
  } catch (const Json::out_of_range&) {
    refuse("something is missing or too large");
  } catch (const Json::exception&) {
    refuse("something is of another type");
  }
}

}  // namespace hackle
