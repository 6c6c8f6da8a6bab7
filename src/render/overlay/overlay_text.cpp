// SPDX-License-Identifier: MIT
#include "render/overlay/overlay_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace hackle {

std::string slow_motion_text(double factor) {
  constexpr double sane = 1e15;  // also keeps rounding within integers
  if (!(factor > 0.0) || factor > sane) return "";
  const bool slowed = factor >= 1.0;
  const double times = slowed ? factor : 1.0 / factor;
  const char* verb = slowed ? "slowed" : "sped up";
  if (times < 1e3 || times > sane) return fmt::format("{} {:.3g} times", verb, times);
  const double unit = std::pow(10.0, std::floor(std::log10(times)) - 2.0);
  return fmt::format("{} {} times", verb, grouped(std::llround(std::round(times / unit) * unit)));
}

std::string time_text(double time) {
  if (time < 1e-3) return fmt::format("{:.2f} µs", time * 1e6);
  if (time < 1.0) return fmt::format("{:.4f} ms", time * 1e3);
  return fmt::format("{:.4f} s", time);
}

std::string printed_unit(const std::string& name) {
  std::string printed = name.size() > 1 && name.front() == 'u' ? "µ" + name.substr(1) : name;
  if (printed.ends_with("m2")) printed.replace(printed.size() - 1, 1, "²");
  if (printed.ends_with("m3")) printed.replace(printed.size() - 1, 1, "³");
  return printed;
}

}  // namespace hackle
