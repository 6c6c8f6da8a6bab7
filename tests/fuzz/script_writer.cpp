// SPDX-License-Identifier: MIT
#include "fuzz/script_writer.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "console/reference/vocabulary.hpp"

namespace hackle::test {
namespace {

using Pool = std::span<const std::string_view>;

constexpr auto lengths = std::to_array<std::string_view>(
    {"1*mm", "2*mm", "5*mm", "10*mm", "20*mm", "0.5*mm", "0", "-1*mm", "1e-9", "1e12", "1e300"});
constexpr auto times = std::to_array<std::string_view>(
    {"0.2*us", "1*us", "0.5*us", "2*us", "0", "-1*us", "1e-300", "1e-12", "1e9", "1e300"});
constexpr auto pixels =
    std::to_array<std::string_view>({"320", "322", "64", "321", "0", "-2", "1e9", "2^53"});
constexpr auto numbers = std::to_array<std::string_view>(
    {"1", "0.5", "0", "2", "10", "1e6", "12e6", "0.9", "45", "-1", "-0.5", "1e-3", "1e-300",
     "1e300", "-1e300", "2^53", "math.maxinteger", "math.mininteger"});
constexpr auto texts = std::to_array<std::string_view>(
    {"'a.png'", "'b.mp4'", "'c.h5'", "'c.xdmf'", "'d/e.png'", "'../x.png'", "'/etc/passwd'", "'.'",
     "'d'", "'bore'", "'a\\0b.png'", "('x'):rep(5000)", "'\\xff\\xfe.png'", "'%s%n.png'",
     "'{}.mp4'"});
constexpr auto nasties = std::to_array<std::string_view>({"nil",
                                                          "true",
                                                          "{}",
                                                          "'text'",
                                                          "''",
                                                          "0/0",
                                                          "1/0",
                                                          "-1/0",
                                                          "print",
                                                          "p",
                                                          "s",
                                                          "m",
                                                          "coroutine.create(print)",
                                                          "{{}}",
                                                          "{1}",
                                                          "{{0, 0}, {1*mm, 1*mm}}",
                                                          "setmetatable({}, {__index = error})",
                                                          "{[1] = 1, [3] = 1}",
                                                          "{0/0, 1}",
                                                          "{1e300, -1e300}",
                                                          "io.stdout",
                                                          "s.run"});
constexpr auto functions = std::to_array<std::string_view>(
    {"function() return 0, 1e6 end",
     "function(x, y) return x, y or x end",
     "function() end",
     "function() error {} end",
     "function() error('x') end",
     "function() return 0/0, 0/0 end",
     "function() s:run(1*us) end",
     "function() s:step(1) return 1, 1 end",
     "function() s = nil collectgarbage() return 1, 1 end",
     "function() s:close() return 1, 1 end",
     "function() coroutine.yield(1, 1) return 1, 1 end",
     "function() s:stop() return 1, 1 end",
     "function() s:traction { edge = 'top', stress = {0, 1e7} } return 1, 1 end",
     "function() s:on { 'every', every = 1*us, call = print } return 1, 1 end",
     "function() t = s:fork() t:step(1) return 1, 1 end",
     "function() s:rewind(t or s) return 1, 1 end",
     "function() s:frame { 'f.png', width = 320 } return 1, 1 end",
     "function() p:hole { centre = {5*mm, 5*mm}, radius = 1*mm } return 1, 1 end",
     "function() s = simulate(p, { spacing = 2*mm }) return 1, 1 end",
     "function() return s:report(), 1 end",
     "function(...) return ... end",
     "print",
     "error",
     "(function() local function f(x) return 1 + f(x) end return f end)()"});
// Statements between calls.
constexpr auto statements = std::to_array<std::string_view>(
    {"s:run(1*us)",
     "s:step(3)",
     "collectgarbage()",
     "s = simulate(p, { spacing = 1*mm })",
     "s = simulate(p, { spacing = 2*mm, precision = 'f32' })",
     "t = s:fork()",
     "s:rewind(t)",
     "s, t = t, s",
     "s:close()",
     "s = nil",
     "t = nil",
     "p = plate { width = 20*mm, height = 10*mm, material = 'duran50' }",
     "co = coroutine.wrap(function() s:run(1*us) coroutine.yield() s:run(1*us) end) co()",
     "co()",
     "_ = tostring(s) .. tostring(p) .. tostring(m)",
     "_ = s.energy, s.damage, s.hash, s.time",
     "s.x = 1",
     "_ = p.nothing",
     "local s <close> = s",
     "os.exit(3)",
     "_ = s.energy.kinetic + p"});

// Hands out the bytes, then zeros.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  std::size_t below(std::size_t count) {
    if (bytes_.empty()) return 0;
    const std::size_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value % count;
  }
  std::string pick(Pool pool) { return std::string(pool[below(pool.size())]); }
  bool once_in(std::size_t count) { return below(count) + 1 == count; }

 private:
  std::span<const std::uint8_t> bytes_;
};

std::string number(Bytes& bytes, std::string_view unit) {
  if (unit == "m") return bytes.pick(lengths);
  if (unit == "s") return bytes.pick(times);
  if (unit == "px") return bytes.pick(pixels);
  return bytes.pick(numbers);
}

std::string point(Bytes& bytes, std::string_view unit) {
  const std::string x = number(bytes, unit);
  return fmt::format("{{{}, {}}}", x, number(bytes, unit));
}

template <class Item>
std::string list(Bytes& bytes, Item item) {
  std::string all;
  for (std::size_t count = 1 + bytes.below(6); count > 0; --count) all += item() + ", ";
  return "{" + all + "}";
}

// Returns a value of the type, or sometimes of another.
std::string value(Bytes& bytes, const Option& option) {
  if (bytes.once_in(12)) return bytes.pick(nasties);
  const auto a_point = [&] { return point(bytes, option.unit); };
  switch (option.type) {
    case OptionType::number:
    case OptionType::integer:
      return number(bytes, option.unit);
    case OptionType::text:
      return bytes.pick(texts);
    case OptionType::caption:
      return bytes.once_in(4) ? "''" : bytes.pick(texts);
    case OptionType::texts:
    case OptionType::columns:
      return list(bytes, [&] { return bytes.pick(texts); });
    case OptionType::flag:
      return bytes.once_in(2) ? "true" : "false";
    case OptionType::point:
    case OptionType::pair:
      return a_point();
    case OptionType::window:
      return fmt::format("{{{0}, {0}, {0}}}", number(bytes, option.unit));
    case OptionType::points:
    case OptionType::amplitude:
      return bytes.once_in(4) ? bytes.pick(functions) : list(bytes, a_point);
    case OptionType::markers:
      return list(bytes, [&] {
        const std::string place = number(bytes, option.unit);
        return fmt::format("{{{0}, {0}, {1}}}", place, bytes.pick(texts));
      });
    case OptionType::numbers:
      return list(bytes, [&] { return number(bytes, option.unit); });
    case OptionType::recordings:
    case OptionType::sources:
      return list(bytes, [] { return std::string("r"); });
    case OptionType::choice:
      return fmt::format("'{}'", bytes.pick(option.choices));
    case OptionType::areas: {
      const std::string centre = point(bytes, "m"), radius = number(bytes, "m");
      const std::string area = fmt::format("{{centre = {}, radius = {}}}", centre, radius);
      return bytes.once_in(2) ? area : fmt::format("{{{0}, {0}}}", area);
    }
    case OptionType::material:
      return bytes.once_in(2) ? "m" : "'soda_lime'";
    case OptionType::vector_field:
      return bytes.once_in(3) ? bytes.pick(functions) : a_point();
    case OptionType::scalar_field:
      return bytes.once_in(3) ? bytes.pick(functions) : number(bytes, option.unit);
    case OptionType::function:
      return bytes.pick(functions);
    case OptionType::reading:
      return bytes.once_in(3) ? bytes.pick(functions) : number(bytes, option.unit);
  }
  return "nil";
}

// Writes required options almost always, others sometimes.
std::string options(Bytes& bytes, const FunctionDoc& doc) {
  std::string all;
  for (const Option& option : doc.options)
    if (option.required ? !bytes.once_in(20) : bytes.once_in(option.alternative ? 2 : 4))
      all += fmt::format("{} = {}, ", option.name, value(bytes, option));
  return "{" + all + "}";
}

std::string values(Bytes& bytes, const FunctionDoc& doc) {
  std::string all;
  for (const Option& option : doc.options) all += (all.empty() ? "" : ", ") + value(bytes, option);
  return all;
}

std::string arguments(Bytes& bytes, const FunctionDoc& doc) {
  const std::string leading = doc.leading.empty()    ? ""
                              : bytes.once_in(10)    ? bytes.pick(nasties)
                              : doc.name == "rewind" ? "t"
                                                     : "p";
  if (doc.call == Call::free) return bytes.once_in(2) ? bytes.pick(nasties) : bytes.pick(texts);
  const std::string rest = doc.call == Call::options ? options(bytes, doc) : values(bytes, doc);
  return leading + (leading.empty() || rest.empty() ? "" : ", ") + rest;
}

std::string call_of_method(Bytes& bytes, const TypeDoc& type) {
  const FunctionDoc& doc = *type.methods[bytes.below(type.methods.size())].doc;
  const std::string owner(type.methods.front().doc->owner);
  const std::string self = bytes.once_in(16) ? bytes.pick(nasties) : owner;
  return fmt::format("{}.{}({}, {})", owner, doc.name, self, arguments(bytes, doc));
}

std::string call_of_function(Bytes& bytes) {
  const std::vector<Function> all = all_functions();
  const FunctionDoc& doc = *all[bytes.below(all.size())].doc;
  const std::string kept = doc.name == "plate"       ? "p = "
                           : doc.name == "simulate"  ? "s = "
                           : doc.name == "material"  ? "m = "
                           : doc.name == "recording" ? "r = "
                                                     : "_ = ";
  return fmt::format("{}{}({})", kept, doc.name, arguments(bytes, doc));
}

std::string statement(Bytes& bytes) {
  const std::vector<const TypeDoc*> types = all_types();
  const std::size_t kind = bytes.below(8);
  if (kind == 0) return call_of_function(bytes);
  if (kind == 1) return bytes.pick(statements);
  const TypeDoc& type = *types[bytes.below(types.size())];
  return type.methods.empty() ? bytes.pick(statements) : call_of_method(bytes, type);
}

constexpr const char* prologue = R"(
print = function() end
m = material "duran50"
p = plate { width = 20*mm, height = 10*mm, material = m }
p:crack { from = {0, 5*mm}, to = {10*mm, 5*mm} }
p:traction { edge = "top", stress = {0, 12*MPa} }:clamp { edge = "bottom", depth = 2*mm }
s = simulate(p, { spacing = 1*mm })
t = s:fork()
t:record { "r.h5", every = 1*us }
t:run(1*us)
t:close()
r = recording "r.h5"
t = s:fork()
)";

}  // namespace

std::string script_of(std::span<const std::uint8_t> input) {
  constexpr int max_statements = 16;
  Bytes bytes(input);
  std::string script = prologue;
  for (int k = 0; k < max_statements && !bytes.empty(); ++k)
    script += fmt::format("pcall(function() {} end)\n", statement(bytes));
  return script;
}

}  // namespace hackle::test
