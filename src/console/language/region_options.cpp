// SPDX-License-Identifier: MIT
#include "console/language/region_options.hpp"

#include <fmt/format.h>

namespace hackle {

Region region_of(Arguments& arguments, const Plate& plate, std::string_view who) {
  int begun = 0, whole = 0;
  for (const auto& [one, other] :
       {std::pair{"edge", "depth"}, {"from", "to"}, {"centre", "radius"}}) {
    if (!arguments.good({one, other})) return std::nullopt;
    begun += arguments.has(one) || arguments.has(other) ? 1 : 0;
    whole += arguments.has(one) && arguments.has(other) ? 1 : 0;
  }
  if (begun == 0) return std::nullopt;
  if (begun != 1 || whole != 1) {
    arguments.problems.add(fmt::format("{}: the area is not clear", who),
                           "give edge and depth, or from and to, or centre and radius");
    return std::nullopt;
  }
  if (arguments.has("edge"))
    return strip(plate, arguments.choice<Edge>("edge"), arguments.number("depth"));
  if (arguments.has("from")) return rectangle(arguments.point("from"), arguments.point("to"));
  return Ellipse{arguments.point("centre"), Vec2::Constant(arguments.number("radius")), 0.0};
}

}  // namespace hackle
