// SPDX-License-Identifier: MIT
// The fields of pictures: quantities with one value per node, and their default appearance.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/described.hpp"
#include "measure/bond_field.hpp"
#include "measure/field.hpp"

namespace hackle {

// The values at the two ends of a colour bar, SI.
struct Ends {
  double min = 0.0;
  double max = 1.0;
};

template <>
inline constexpr auto description_of<Ends> = describe_noun("ends", "ends",
                                                           member("least", &Ends::min),
                                                           member("most", &Ends::max));

// The value of a pixel that covers many nodes: the largest, so that features one node wide stay
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
  // Computes the range from the strength of the plate's own material, so that pictures of one scene
  // are comparable and the range of a movie is known from the first frame.
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
// Throws Error (refused), with the nearest name, for an unknown name.
const Scalar& scalar_of(std::string_view name);

// "fringes" is the order of isochromatics, N = (sigma_1 - sigma_2) h/f, for a plate 1 m thick: its
// values and range grow in proportion to the thickness h. f is Material::fringe. Throws Error
// (refused), as its values do, if a material of the lattice has no f.
inline constexpr std::string_view fringes_name = "fringes";
void check_fringes(const Lattice& lattice);
// Returns the fringes of these stresses, by Grid::index, for a plate 1 m thick.
std::vector<float> fringes_of(const View& view, const std::vector<Stress>& stresses);

}  // namespace hackle
