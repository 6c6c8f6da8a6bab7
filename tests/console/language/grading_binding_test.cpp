// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

constexpr const char* graded_plate =
    "p = plate { width = 20*mm, height = 10*mm, material = 'duran50' }\n";

TEST(GradingBinding, MakesInclusionsInLevels) {
  EXPECT_EQ(test::message_of(std::string(graded_plate) +
                             "p:grade { E = function(x, y) return (40 + 1000*x)*GPa end,\n"
                             "  levels = 8, cell = 1*mm }\n"
                             "assert(tostring(p):find('8 inclusions (E 41.5 GPa to 58.5 GPa)', 1, "
                             "true), tostring(p))\n"
                             "p:grade { strength = 0.5, centre = {5*mm, 5*mm}, radius = 3*mm }\n"
                             "assert(tostring(p):find('9 inclusions', 1, true), tostring(p))\n"
                             "simulate(p, { spacing = 1*mm }):run(1*us)"),
            "");
}

struct BadGrading {
  const char* call;
  const char* part;  // of the message
};

TEST(GradingBinding, SaysWhatIsWrong) {
  for (const auto& [call, part] :
       {BadGrading{"p:grade {}", "nothing is graded"},
        BadGrading{"p:grade { levels = 4 }", "give E, rho, G0 or strength"},
        BadGrading{"p:grade { Ee = 5 }", "did you mean 'E'?"},
        BadGrading{"p:grade { E = -1 }", "must be above 0 Pa"},
        BadGrading{"p:grade { E = 1e9, levels = 1 }", "between 2 and 254"},
        BadGrading{"p:grade { E = 1e9, cell = 1e-9 }", "give larger cells"},
        BadGrading{"p:grade { E = function(x, y) return 1e9*(y - 1) end }", "grade: E is"},
        BadGrading{"p:grade { rho = function(x, y) end }", "the function returns nothing at x ="},
        BadGrading{"p:grade { E = 1e9, centre = {1, 1} }", "the shape is not clear"},
        BadGrading{"p:grade { E = 1e9, material = 'duran' }", "did you mean 'duran50'?"}})
    EXPECT_THAT(test::message_of(graded_plate + std::string(call)), HasSubstr(part)) << call;
}

}  // namespace
}  // namespace hackle
