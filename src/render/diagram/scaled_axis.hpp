// SPDX-License-Identifier: MIT
// Where the values of an axis lie, and what stands beside it.
#pragma once

#include <string>
#include <vector>

#include "measure/scalar.hpp"
#include "render/diagram/diagram.hpp"

namespace hackle {

class ScaledAxis {
 public:
  // Without a range of its own the axis spans `seen`, extended to the next ticks if it `encloses`
  // them, to 0 where that is near. At most so many intervals lie between its ticks.
  ScaledAxis(const DiagramAxis& axis, const Ends& seen, int intervals, bool encloses);

  // Returns the share of the axis below the value, 0..1 within its range. On a logarithmic axis the
  // value must be above 0.
  double share(double value) const;
  bool holds(double value) const;  // whether it can have a place
  const Ends& ends() const { return ends_; }
  const std::vector<double>& ticks() const { return ticks_; }
  const std::vector<std::string>& texts() const { return texts_; }  // one for each tick
  const std::string& heading() const { return heading_; }           // "tip speed (m/s)"

 private:
  void find_ends(const Ends& seen, int intervals, bool encloses);

  const bool logarithmic_;
  Ends ends_;
  std::vector<double> ticks_;
  std::vector<std::string> texts_;
  std::string heading_;
};

}  // namespace hackle
