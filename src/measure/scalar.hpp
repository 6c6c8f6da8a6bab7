// SPDX-License-Identifier: MIT
// What can be painted: quantities with one value per node, and how a picture shows each unless it
// is told otherwise.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/described.hpp"
#include "measure/field.hpp"

namespace hackle {

// The values at the two ends of a colour bar, SI.
struct Ends {
  double least = 0.0;
  double most = 1.0;
};

template <>
inline constexpr auto description_of<Ends> = describe_noun("ends", "ends",
                                                           member("least", &Ends::least),
                                                           member("most", &Ends::most));

// What a pixel that covers many nodes shows: the largest value, so that features one node wide stay
// visible, or the mean.
enum class Sampling { largest, mean };

struct Scalar {
  std::string_view name;      // "stress_1"
  std::string_view label;     // "largest stress", at the colour bar
  std::string_view unit;      // SI
  std::string_view sentence;  // for help()
  std::string_view colours;   // a colour map
  Sampling sampling = Sampling::mean;
  bool logarithmic = false;
  // From the strength of the plate's own material, so that pictures of one scene can be compared
  // and a movie knows them from its first frame.
  Ends (*ends)(const View&) = nullptr;
  std::vector<float> (*values)(const View&) = nullptr;  // by Grid::index
};

inline constexpr auto scalar_names = std::to_array<std::string_view>(
    {"damage",     "displacement", "displacement_x", "displacement_y", "speed",     "velocity_x",
     "velocity_y", "stretch",      "energy_density", "stress_xx",      "stress_yy", "stress_xy",
     "stress_1",   "stress_2",     "stress_mean",    "von_mises",      "shear",     "fringes",
     "fragments",  "strength",     "temperature"});

// In the order of scalar_names.
std::span<const Scalar> scalars();
// Throws Error (refused), with the nearest name, when there is none.
const Scalar& scalar_of(std::string_view name);

// "fringes" is the order of isochromatics, N = (sigma_1 - sigma_2) h/f, for a plate 1 m thick: its
// values and ends grow in proportion to the thickness h. f is Material::fringe. Throws Error
// (refused), as its values do, when a material of the lattice has none.
inline constexpr std::string_view fringes_name = "fringes";
void check_fringes(const Lattice& lattice);

}  // namespace hackle
