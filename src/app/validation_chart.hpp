// SPDX-License-Identifier: MIT
// Small charts of expectations, as SVG for a page.
#pragma once

#include <string>

#include "output/report/expectation.hpp"

namespace hackle {

// Returns a curve of its quantity along its axis: what is expected as a line, what was got as dots.
// Colours are the classes of the page: grid, line, dot, label.
std::string curve_chart(const Expectation& expectation);

// Returns where the value lies between its bounds, as a mark on a bar; "" if there are not two.
std::string bounds_chart(const Expectation& expectation);

}  // namespace hackle
