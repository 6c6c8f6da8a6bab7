// SPDX-License-Identifier: MIT
// Every option of every function is given invalid values of every kind: the call must be refused by
// name, and the message must name the option.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "console/reference/vocabulary.hpp"
#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

using Values = std::vector<std::string>;

const Values no_pairs{"5",        "'a'",      "{}",   "{1}",     "{1, 'a'}",
                      "{0/0, 0}", "{0, 1/0}", "true", "{{1, 2}}"};

// Lua expressions that no option of the type accepts, whatever its range.
Values nonsense(OptionType type) {
  switch (type) {
    case OptionType::number:
      return {"'x'", "'1'", "{}", "true", "0/0", "1/0", "-1/0", "function() end", "print"};
    case OptionType::integer:
      return {"'1'", "{}", "1.5", "0/0", "1/0", "2^63", "false", "function() end"};
    case OptionType::text:
      return {"5", "{}", "''", "false", "function() end"};
    case OptionType::caption:
      return {"5", "{}", "'\\0'", "false", "function() end"};
    case OptionType::texts:
      return {"5", "'a'", "{}", "{5}", "{''}", "{{}}"};
    case OptionType::flag:
      return {"1", "'true'", "{}", "function() end"};
    case OptionType::point:
    case OptionType::pair:
      return no_pairs;
    case OptionType::window:
      return {"5",           "'a'",         "{}",          "{1, 1}",       "{1, 1, 'a'}",
              "{0/0, 0, 1}", "{0, 1/0, 1}", "{0, 0, 0/0}", "{1, 1, 1, 1}", "{0, 0, 0}",
              "{0, 0, -1}",  "true"};
    case OptionType::points:
      return {"5",
              "'a'",
              "{}",
              "{5}",
              "{{1}}",
              "{{0, 0}, 'a'}",
              "{{0/0, 0}, {1, 1}}",
              "{{1, 1/0}, {0, 0}}"};
    case OptionType::markers:
      return {"5",
              "'a'",
              "{}",
              "{5}",
              "{{0, 0}}",
              "{{0, 0, 5}}",
              "{{'0', 0, 'a'}}",
              "{{0/0, 0, 'a'}}",
              "{{0, 1/0, 'a'}}",
              "{{0, 0, '\\0'}}",
              "{{0, 0, 'a', 1}}",
              "{{0, 0, 'a'}, 5}",
              "{{0, 0, 'a'}, b = 1}"};
    case OptionType::choice:
      return {"5", "{}", "'nonsense'", "''", "true"};
    case OptionType::numbers:
      return {"5", "'a'", "{}", "{'a'}", "{0/0}", "{1, 1/0}", "{1, x = 1}", "{{}}"};
    case OptionType::recordings:
      return {"5", "r", "{}", "{5}", "{'r.h5'}", "{s}", "{r, p}", "{r, x = r}"};
    case OptionType::sources:
      return {"5", "'a.csv'", "{}", "{5}", "{{}}", "{{a = 5}}", "{{a = {1}, b = {1, 2}}}", "{p}"};
    case OptionType::columns:
      return {"5", "'time'", "{}", "{5}", "{{}}", "{{a = 5}}", "{p}"};
    case OptionType::material:
      return {"5", "'glas'", "{}", "true", "print"};
    case OptionType::areas:
      return {"5",
              "'a'",
              "{}",
              "true",
              "{5}",
              "{centre = {0, 0}}",
              "{centre = {0, 0}, radius = -1}",
              "{{points = {{0, 0}, {1, 1}}}}",
              "{{centre = {0, 0}, radius = 1}, 5}",
              "{centre = {0, 0}, radius = 1, colour = 'red'}"};
    case OptionType::vector_field:
      return no_pairs;
    case OptionType::scalar_field:
      return {"'a'", "{}", "0/0", "1/0", "true"};
    case OptionType::function:
      return {"5", "'print'", "{}", "true"};
    case OptionType::reading:
      return {"'1'", "{}", "{'a'}", "{{1, 2}}", "{1, x = 2}", "true", "p"};
    case OptionType::amplitude:
      return {"5",          "'a'",        "{}",
              "{5}",        "{{0}}",      "{{0, 'a'}}",
              "{{0, 0/0}}", "{{1/0, 1}}", "{{1, 1}, {0, 0}}",
              "true"};
  }
  return {};
}

// Returns numbers just outside the range.
Values outside(const Option& option) {
  Values values;
  if (option.type != OptionType::number && option.type != OptionType::integer) return values;
  const Range& range = option.range;
  if (std::isfinite(range.min))
    values.push_back(fmt::format("{:.17g}", range.min_inclusive ? range.min - 1.0 : range.min));
  if (std::isfinite(range.max)) values.push_back(fmt::format("{:.17g}", 2.0 * range.max + 1.0));
  return values;
}

std::string call_of(const FunctionDoc& doc, const Option& option, const std::string& value) {
  const std::string who =
      (doc.owner.empty() ? "" : std::string(doc.owner) + ":") + std::string(doc.name);
  const std::string leading = doc.leading.empty() ? "" : std::string(doc.leading) + ", ";
  if (doc.call == Call::options)
    return fmt::format("{}({}{{ {} = {} }})", who, leading, option.name, value);
  std::string nils;
  for (const Option& other : doc.options) {
    if (other.name == option.name) break;
    nils += "nil, ";
  }
  return fmt::format("{}({}{}{})", who, leading, nils, value);
}

class EveryFunction : public testing::TestWithParam<const FunctionDoc*> {};

TEST_P(EveryFunction, RefusesNonsenseByTheNameOfTheOption) {
  const FunctionDoc& doc = *GetParam();
  if (doc.call == Call::free) return;
  const test::Folder folder;
  Console console(test::quiet(folder.path));
  console.evaluate(test::scene + test::recorded);
  for (const Option& option : doc.options) {
    Values values = nonsense(option.type);
    for (const std::string& value : outside(option)) values.push_back(value);
    for (const std::string& value : values) {
      const std::string call = call_of(doc, option, value);
      try {
        console.evaluate(call);
        ADD_FAILURE() << call << " is taken";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::refused) << call << "\n" << error.what();
        EXPECT_THAT(error.what(), HasSubstr(std::string(doc.name) + ": "));
        // The unknown name itself is specific enough.
        EXPECT_THAT(error.what(), testing::AnyOf(HasSubstr(std::string(option.name)),
                                                 HasSubstr("no material " + value)))
            << call;
      }
    }
  }
}

TEST_P(EveryFunction, OffersTheNearestNameForAMisspelledOption) {
  const FunctionDoc& doc = *GetParam();
  if (doc.call != Call::options) return;
  const test::Folder folder;
  Console console(test::quiet(folder.path));
  console.evaluate(test::scene + test::recorded);
  for (const Option& option : doc.options) {
    if (option.name.size() < 4) continue;
    std::string misspelled(option.name);
    misspelled.erase(misspelled.size() - 2, 1);
    if (find_option(doc, misspelled) != nullptr) continue;
    const Option renamed{.name = misspelled};
    try {
      console.evaluate(call_of(doc, renamed, "1"));
      ADD_FAILURE() << doc.name << ": " << misspelled << " is taken";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr(fmt::format("unknown option '{}' (did you mean '", misspelled)));
    }
  }
}

std::string name_of(const FunctionDoc& doc) {
  std::string name =
      (doc.owner.empty() ? "" : std::string(doc.owner) + "_") + std::string(doc.name);
  std::ranges::replace(name, '.', '_');  // study.trade
  return name;
}

INSTANTIATE_TEST_SUITE_P(Calls, EveryFunction, testing::ValuesIn(all_docs()),
                         [](const auto& given) { return name_of(*given.param); });

// Functions that fail everywhere, or from the middle of the plate or of the run on.
const Values bad_functions{
    "function() end",
    "function() return 'a', 'b' end",
    "function() return {} end",
    "function() return 0/0, 0/0 end",
    "function() return 1/0, -1/0 end",
    "function() error('no') end",
    "function() error({}) end",
    "(function() local function f(x) return 1 + f(x) end return f end)()",
    "function(x) if x > 2e-6 then return nil end return 0, 0 end",
    "function() return p:hole { centre = {5*mm, 5*mm}, radius = 1*mm } end",
};

const std::string hot =
    "p = plate { width = 20*mm, height = 10*mm, material = material { like = 'duran50', alphaT = "
    "3e-6 } }\n"
    "p:hole { centre = {10*mm, 5*mm}, radius = 2*mm, name = 'bore' }\n"
    "s = simulate(p, { spacing = 1*mm })\n";

// `call` has % in place of the function. The plate must be refused, and the present simulation must
// be unchanged.
void expect_refusal(const std::string& call, const std::string& where) {
  for (const std::string& function : bad_functions) {
    std::string text = call;
    text.replace(text.find('%'), 1, function);
    Console console(test::quiet());
    console.evaluate(hot);
    try {
      console.evaluate(text);
      ADD_FAILURE() << text << " is taken";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(where)) << text;
    }
    EXPECT_EQ(console.evaluate("s.time == 0 and s.energy.external == 0").at(0), "true") << text;
    EXPECT_EQ(console.evaluate("s.damage.broken_bonds").at(0), "0");
  }
}

TEST(BadFunctions, OfPlaceAreRefusedWhereTheyFail) {
  for (const std::string call :
       {"traction { edge = 'top', stress = % }", "body_force { force = % }",
        "move { edge = 'top', depth = 2*mm, velocity = % }",
        "move { edge = 'top', depth = 2*mm, displacement = % }", "temperature { change = % }"}) {
    expect_refusal("p:" + call + " simulate(p, { spacing = 1*mm })", "mm, ");
    expect_refusal("s:" + call, "mm, ");
  }
  for (const std::string call : {"initial { velocity = % }", "initial { displacement = % }"})
    expect_refusal("p:" + call + " simulate(p, { spacing = 1*mm })", "mm, ");
}

TEST(BadFunctions, OfTimeAreRefusedBeforeTheRun) {
  for (const std::string call : {"traction { edge = 'top', stress = {0, 1*MPa}, time = % }",
                                 "pressure { rim = 'bore', pressure = 1*MPa, time = % }",
                                 "body_force { force = {0, 1e6}, time = % }",
                                 "move { edge = 'top', depth = 2*mm, velocity = {0, 1}, time = % }",
                                 "temperature { change = 10, time = % }"}) {
    expect_refusal("p:" + call + " simulate(p, { spacing = 1*mm }):run(5*us)", "s");
    expect_refusal("s:" + call + " s:run(5*us)", "s");
  }
}

TEST(BadFunctions, MayNotRunTheSimulationTheyLoad) {
  for (const std::string call :
       {"s:traction { edge = 'top', stress = f }", "s:temperature { change = f }",
        "s:traction { edge = 'top', stress = {0, 1}, time = f } s:run(1*us)"})
    for (const std::string function :
         {"s:run(1*us)", "s:traction { edge = 'top', stress = {0, 2} }", "s:relax {}"}) {
      Console console(test::quiet());
      console.evaluate(hot + "function f() " + function + " return 1, 1 end");
      try {
        console.evaluate(call);
        ADD_FAILURE() << call << " with " << function << " is taken";
      } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("the simulation is running")) << call << function;
      }
      EXPECT_EQ(console.evaluate("s.time").at(0), "0.0");
    }
}

}  // namespace
}  // namespace hackle
