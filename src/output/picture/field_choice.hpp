// SPDX-License-Identifier: MIT
// The field of a picture, and how it is painted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/scalar.hpp"
#include "output/picture/picture.hpp"
#include "solver/view.hpp"

namespace hackle {

struct FieldChoice {
  const Scalar& scalar;
  std::optional<Ends> range;
  std::string colours;
  bool logarithmic = false;
  double thickness = 0.0;  // m
  bool average = false;    // over a horizon

  bool is_fringes() const { return scalar.name == fringes_name; }
  // Returns whether its values have no natural limit, as shares and counts have.
  bool is_unlimited() const { return is_fringes() || !scalar.unit.empty(); }
};

// Return the fields of a picture; the second only if the options have one.
FieldChoice first_field(const PictureOptions& options);
FieldChoice second_field(const PictureOptions& options);

// Returns the field's own range, or four decades for a logarithmic scale if it has none.
Ends usual_ends(const FieldChoice& field, const View& view);
// Returns values by Grid::index; nan without material, where pictures show the background.
std::vector<float> values_of(const FieldChoice& field, const View& view);

// Returns whether the colour bar is logarithmic.
bool is_logarithmic(const PictureOptions& options);
// Returns the default range of the field, whatever the options request: it depends only on the
// plate.
Ends usual_ends(const PictureOptions& options, const View& view);

// Returns the values to paint, by Grid::index; nan without material.
std::vector<float> field_values(const PictureOptions& options, const View& view);

}  // namespace hackle
