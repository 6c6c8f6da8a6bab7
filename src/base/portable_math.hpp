// SPDX-License-Identifier: MIT
// Functions of analysis by + - * / and square roots alone: the same bits on every machine, where
// those of the C library may differ in the last. Good to some 1e-14 of the value.
#pragma once

namespace hackle::portable {

// x > 0 and normal.
double log(double x);
// log(1 + x), exact to rounding for small x; x > -1.
double log1p(double x);
// |x| < 700.
double exp(double x);
// Gamma(x), 1 <= x <= 20.
double gamma(double x);
// The share of a standard normal distribution below x, and so precise in the lower tail, too.
double normal_below(double x);

}  // namespace hackle::portable
