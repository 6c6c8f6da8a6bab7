// SPDX-License-Identifier: MIT
// p:contact{} and p:impactor{}, as a script calls them.
#include "console/language/contact_binding.hpp"

#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;

const std::string small_plate =
    "p = plate { width = 30*mm, height = 20*mm, material = 'duran50' }\n";
const std::string disc = "{ centre = {-4.01*mm, 10*mm}, radius = 4*mm, velocity = {50, 0}";

std::string after_small_plate(const std::string& calls) {
  return test::message_of(small_plate + calls);
}

TEST(ContactBinding, IsSaidByThePlateAndTheLedger) {
  EXPECT_EQ(after_small_plate("p:contact {}\n"
                              "assert(tostring(p):find(', contact', 1, true), tostring(p))\n"
                              "p:contact { stiffness = 30, reach = 1 }\n"
                              "s = simulate(p, { spacing = 1*mm })\n"
                              "assert(s.energy.contact == 0)\n"),
            "");
}

TEST(ContactBinding, LowersTheLimitOfTheStep) {
  EXPECT_EQ(after_small_plate("local free = simulate(p, { spacing = 1*mm }).dt_limit\n"
                              "p:contact {}\n"
                              "local touching = simulate(p, { spacing = 1*mm }).dt_limit\n"
                              "assert(touching < 0.8*free and touching > 0.6*free)\n"),
            "");
}

TEST(ContactBinding, RefusesWhatMakesNoSense) {
  for (const char* options :
       {"stiffness = 0", "stiffness = -1", "stiffness = 101", "stiffness = 0/0", "stiffness = 'a'",
        "reach = 0", "reach = 1.01", "reach = 1/0", "reach = {}", "reech = 1"})
    EXPECT_THAT(after_small_plate(std::string("p:contact { ") + options + " }"),
                HasSubstr("contact: "))
        << options;
  EXPECT_THAT(after_small_plate("p:contact(5)"), HasSubstr("contact: "));
}

TEST(ImpactorBinding, HitsThePlate) {
  EXPECT_EQ(after_small_plate("p:impactor " + disc + ", density = 2500 }\n" +
                              "s = simulate(p, { spacing = 1*mm })\n"
                              "s:run(20*us)\n"
                              "assert(s.energy.external > 0)\n"),
            "");
}

TEST(ImpactorBinding, MayComeInTheMiddleOfARun) {
  EXPECT_EQ(after_small_plate("s = simulate(p, { spacing = 1*mm })\n"
                              "s:run(5*us)\n"
                              "s:impactor " +
                              disc +
                              ", mass = 0.3 }\n"
                              "s:run(20*us)\n"
                              "assert(s.energy.external > 0)\n"),
            "");
}

TEST(ImpactorBinding, RefusesWhatMakesNoSense) {
  for (const char* options :
       {"", "centre = {0, 0}", "centre = {-5*mm, 0}, radius = 4*mm",
        "centre = {-5*mm, 0}, radius = 0, velocity = {1, 0}",
        "centre = {-5*mm, 0}, radius = -1, velocity = {1, 0}",
        "centre = {0/0, 0}, radius = 1*mm, velocity = {1, 0}",
        "centre = {-5*mm, 0}, radius = 1*mm, velocity = {1/0, 0}",
        "centre = {-5*mm, 0}, radius = 1*mm, velocity = 5",
        "centre = {-5*mm, 0}, radius = 1*mm, velocity = {1, 0}, mass = 0",
        "centre = {-5*mm, 0}, radius = 1*mm, velocity = {1, 0}, density = 'steel'",
        "centre = {-5*mm, 0}, radius = 1*mm, velocity = {1, 0}, mass = 1, density = 1",
        "centre = {-5*mm, 0}, radius = 1*mm, speed = {1, 0}"})
    EXPECT_THAT(after_small_plate(std::string("p:impactor { ") + options + " }"),
                HasSubstr("impactor: "))
        << options;
}

// Only the lattice can detect these.
TEST(ImpactorBinding, RefusesADiscInsideThePlateOrTooSmallOrLight) {
  const auto simulated = [](const std::string& options) {
    return after_small_plate("p:impactor { " + options + " }\nsimulate(p, { spacing = 1*mm })");
  };
  EXPECT_THAT(simulated("centre = {5*mm, 5*mm}, radius = 2*mm, velocity = {1, 0}"),
              HasSubstr("at its start it overlaps the plate by "));
  EXPECT_THAT(simulated("centre = {-5*mm, 5*mm}, radius = 0.5*mm, velocity = {1, 0}"),
              HasSubstr("is under one spacing of 1 mm"));
  EXPECT_THAT(simulated("centre = {-5*mm, 5*mm}, radius = 2*mm, velocity = {1, 0}, mass = 1e-6"),
              HasSubstr("give at least 0.00894 kg/m"));
}

TEST(ImpactorBinding, KeepsAPlateFromComingToRest) {
  EXPECT_THAT(after_small_plate("p:clamp { edge = 'left', depth = 2*mm }\np:impactor " + disc +
                                " }\nsimulate(p, { spacing = 1*mm }):relax()"),
              HasSubstr("a plate that is being hit cannot be brought to rest"));
}

}  // namespace
}  // namespace hackle
