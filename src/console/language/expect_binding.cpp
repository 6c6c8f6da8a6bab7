// SPDX-License-Identifier: MIT
#include "console/language/expect_binding.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "console/language/scripted_expectation.hpp"
#include "console/schema/arguments.hpp"
#include "console/schema/object_type.hpp"
#include "console/session.hpp"

namespace hackle {
namespace {

constexpr std::array expect_options{
    Option{.name = "quantity",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "What is expected, in words."},
    Option{.name = "got",
           .type = OptionType::reading,
           .read = read_reading,
           .range = at_least(1.0),
           .fallback = "nothing: it was not found",
           .sentence = "What the scene gives. A function is called at the end of the script, at "
                       "the prompt at once; with at, for each of its places."},
    Option{.name = "value",
           .type = OptionType::reading,
           .read = read_reading,
           .range = at_least(1.0),
           .alternative = true,
           .sentence = "What the source says, likewise."},
    Option{.name = "tolerance",
           .range = at_least(0.0),
           .fallback = "0",
           .sentence = "Largest difference from value that passes, in the same unit."},
    Option{.name = "relative",
           .range = above(0.0),
           .alternative = true,
           .sentence = "The same as a share of value."},
    Option{.name = "min",
           .alternative = true,
           .sentence = "Or the smallest number that passes, where the source gives bounds."},
    Option{.name = "max", .alternative = true, .sentence = "And the largest."},
    Option{.name = "unit",
           .type = OptionType::caption,
           .fallback = "none",
           .sentence = "Unit of these numbers: m, s, Pa, J and m/s are shown with a prefix, any "
                       "other text as it stands."},
    Option{.name = "source",
           .type = OptionType::text,
           .required = true,
           .sentence = "Who says so: a closed form, a book, a paper, an earlier run."},
    Option{.name = "confirmed",
           .type = OptionType::flag,
           .fallback = "true",
           .sentence = "Whether the source itself has been read."},
    Option{.name = "reason",
           .type = OptionType::text,
           .fallback = "none",
           .sentence = "Why it fails or is unsupported, if that is known."},
    Option{.name = "unsupported",
           .type = OptionType::flag,
           .fallback = "false",
           .sentence = "Whether Hackle cannot compute it at all; reason says why."},
    Option{.name = "at",
           .type = OptionType::numbers,
           .range = at_least(2.0),
           .alternative = true,
           .sentence = "Places of a curve along an axis, for which value and got are lists or "
                       "functions; every point must pass, the worst one is told."},
    Option{.name = "along",
           .type = OptionType::caption,
           .fallback = "none",
           .sentence = "Name of that axis, with its unit."}};

constexpr FunctionDoc expect_doc{
    .name = "expect",
    .sentence =
        "Says what a scene should give, and by which source; returns the verdict: pass, fail or "
        "unsupported. hackle run prints it at the end, hackle validate makes a table of many.",
    .options = expect_options,
    .example =
        "s:run(8*us)\n"
        "expect { \"broken bonds\", got = s.damage.broken_bonds, min = 1, source = \"Freund\" }\n"
        "expect { \"speed of pressure waves\", unit = \"m/s\", got = s.c_L, value = 5720, "
        "relative = 0.01,\n"
        "         source = \"sqrt(E/(rho (1 - nu^2)))\" }"};

// A curve needs as many numbers as places; a number needs no list.
void check_length(Arguments& arguments, const char* name, std::size_t places) {
  const auto reading = arguments.get<Reading>(name, {});
  const auto* list = std::get_if<std::vector<double>>(&reading);
  if (list == nullptr || list->size() == places) return;
  if (places == 0)
    return arguments.problems.add(fmt::format("expect: {} is a list, but at is missing", name),
                                  "at says where its numbers belong");
  arguments.problems.add(
      fmt::format("expect: {} has {} numbers, at has {}", name, list->size(), places));
}

// Exactly one of value and bounds, unless there is nothing to compare.
void check_wishes(Arguments& arguments) {
  const bool value = arguments.has("value"), low = arguments.has("min"),
             high = arguments.has("max");
  const bool good = arguments.good({"value", "min", "max", "tolerance", "relative"});
  if (good && !value && !low && !high && !arguments.flag("unsupported"))
    arguments.problems.add("expect: it is not clear what passes",
                           "give value with tolerance or relative, or min and max");
  if (good && value && (low || high))
    arguments.problems.add("expect: value and bounds are both given", "one of them is enough");
  if (low && high && arguments.number("min") > arguments.number("max"))
    arguments.problems.add("expect: min lies above max");
  if (arguments.has("tolerance") && arguments.has("relative"))
    arguments.problems.add("expect: tolerance and relative are both given", "one is enough");
  if (arguments.flag("unsupported") && !arguments.has("reason"))
    arguments.problems.add("expect: reason is missing", "say why it is unsupported");
  if (arguments.has("at") && !value)
    arguments.problems.add("expect: a curve needs value", "a list or a function");
}

ScriptedExpectation read(Arguments& arguments, const Session& session) {
  check_wishes(arguments);
  Expectation e;
  e.curve.x = arguments.numbers("at");
  for (const char* name : {"value", "got"}) check_length(arguments, name, e.curve.x.size());
  arguments.problems.throw_if_any();
  e.name = session.origin.script_name.empty()
               ? "prompt"
               : std::filesystem::path(session.origin.script_name).stem().string();
  e.quantity = arguments.text("quantity");
  e.unit = arguments.text("unit");
  e.tolerance = arguments.number("tolerance");
  e.relative = arguments.number("relative");
  e.min = arguments.number("min", e.min);
  e.max = arguments.number("max", e.max);
  e.source = arguments.text("source");
  e.confirmed = arguments.flag("confirmed", true);
  e.reason = arguments.text("reason");
  e.unsupported = arguments.flag("unsupported");
  e.curve.along = arguments.text("along");
  return {std::move(e), arguments.get<Reading>("value", {}), arguments.get<Reading>("got", {})};
}

bool is_function(const Reading& reading) {
  return std::holds_alternative<LuaFunction>(reading);
}

int expect(lua_State* L) {
  Session& session = session_of(L);
  Arguments arguments = Arguments::from_table(L, 1, expect_doc);
  const ScriptedExpectation expected = read(arguments, session);
  if (session.settings.purpose != Purpose::results) return 0;
  const bool waits = is_function(expected.value) || is_function(expected.got);
  if (waits && !session.has_prompt()) {
    session.expectations.push_back({expected.known, [expected] { return expected.settled(); }});
    return 0;
  }
  session.expectations.push_back({expected.settled(), nullptr});
  push_text(L, std::string(name_of(session.expectations.back().expectation.verdict())));
  return 1;
}

}  // namespace

std::span<const Function> expect_functions() {
  static constexpr std::array functions{Function{&expect_doc, guarded<expect>}};
  return functions;
}

}  // namespace hackle
