// SPDX-License-Identifier: MIT
// Mathematical functions built from + - * / and square roots only: they give the same bits on every
// machine, where those of the C library may differ in the last bit. Relative error about 1e-14.
#pragma once

namespace hackle::portable {

// Requires x > 0 and normal.
double log(double x);
// Computes log(1 + x), exact to rounding for small x; requires x > -1.
double log1p(double x);
// Requires |x| < 700.
double exp(double x);
// Computes Gamma(x) for 1 <= x <= 20.
double gamma(double x);
// Computes the standard normal distribution function, with full relative precision in the lower
// tail.
double normal_below(double x);

}  // namespace hackle::portable
