// SPDX-License-Identifier: MIT
// A field that a picture shows, and how it is to be painted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/scalar.hpp"
#include "output/picture/picture.hpp"
#include "solver/simulation.hpp"

namespace hackle {

struct FieldChoice {
  const Scalar& scalar;
  std::optional<Ends> range;
  std::string colours;
  bool logarithmic = false;
  double thickness = 0.0;  // m

  bool is_fringes() const { return scalar.name == fringes_name; }
};

// Of a picture; the second one only where the options have it.
FieldChoice first_field(const PictureOptions& options);
FieldChoice second_field(const PictureOptions& options);

// What suits the field; a logarithmic scale of four decades where it has none of its own.
Ends usual_ends(const FieldChoice& field, const Simulation& simulation);
// By Grid::index; nan where there is no material: pictures show the background there.
std::vector<float> values_of(const FieldChoice& field, const Simulation& simulation);

// Whether the colour bar is.
bool is_logarithmic(const PictureOptions& options);
// The range that suits the field, whatever is asked for: it depends on the plate alone.
Ends usual_ends(const PictureOptions& options, const Simulation& simulation);

// What is painted of the field, by Grid::index; nan where there is no material.
std::vector<float> field_values(const PictureOptions& options, const Simulation& simulation);

}  // namespace hackle
