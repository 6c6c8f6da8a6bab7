// SPDX-License-Identifier: MIT
#include "measure/scalar.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "base/text.hpp"
#include "measure/bond_field.hpp"

namespace hackle {
namespace {

using Values = std::vector<float>;

// Scales at which a bond of the plate's own material breaks: its critical stretch, and the stress
// and the speed of a uniaxial wave of that strain.
double critical_stretch(const View& view) {
  return view.lattice().calibration.s0;
}
double critical_stress(const View& view) {
  return view.plate().material.E * critical_stretch(view);
}
double critical_speed(const View& view) {
  const Lattice& lattice = view.lattice();
  return critical_stretch(view) * std::sqrt(lattice.calibration.moduli.C11 / lattice.rho);
}
// Returns the displacement of an edge when the shorter side is stretched by half the critical
// stretch.
double critical_length(const View& view) {
  const Plate& plate = view.plate();
  return 0.25 * critical_stretch(view) * std::min(plate.width, plate.height);
}

template <int min, int max>
Ends fixed(const View&) {
  return {0.01 * min, 0.01 * max};
}

// Returns `least` and `most` per cent of the critical value.
template <double (*critical)(const View&), int min, int max>
Ends share(const View& view) {
  return {0.01 * min * critical(view), 0.01 * max * critical(view)};
}

Ends ends_of_energy(const View& view) {
  const double max = 0.5 * critical_stress(view) * critical_stretch(view);
  return {1e-4 * max, max};
}

double fringes_per_stress(const Material& material) {
  return 1.0 / material.fringe;
}

Ends ends_of_fringes(const View& view) {
  check_fringes(view.lattice());
  return {0.0, critical_stress(view) * fringes_per_stress(view.plate().material)};
}

Ends ends_of_temperature(const View& view) {
  double max = 1.0;
  for (const MaterialOnLattice& known : view.lattice().materials)
    if (known.material.alphaT > 0.0)
      max = std::max(max, 0.5 * known.calibration.s0 / known.material.alphaT);
  return {-max, max};
}

Values damages(const View& view) {
  return damage(view).values;
}

// Component 0 or 1 of a vector field, or its length.
enum class Part { x, y, length };

template <Field (*vectors)(const View&), Part part>
Values part_of(const View& view) {
  const Field field = vectors(view);
  Values values(field.values.size() / 2);
  for (std::size_t node = 0; node < values.size(); ++node) {
    const float x = field.values[2 * node], y = field.values[2 * node + 1];
    values[node] = part == Part::x ? x : part == Part::y ? y : std::hypot(x, y);
  }
  return values;
}

template <class Number>
Values as_floats(const std::vector<Number>& numbers) {
  return {numbers.begin(), numbers.end()};
}

template <auto of>
Values stress_part(const View& view) {
  const std::vector<Stress> all = stresses(view);
  Values values(all.size());
  std::ranges::transform(all, values.begin(), [](const Stress& stress) {
    return static_cast<float>(std::invoke(of, stress));
  });
  return values;
}

double mean_in_plane(const Stress& stress) {
  return 0.5 * (stress.xx + stress.yy);
}

Values closeness(const View& view) {
  return as_floats(closest_to_breaking(view));
}
Values energies(const View& view) {
  return as_floats(energy_densities(view));
}
Values fragments(const View& view) {
  return as_floats(fragment_numbers(view));
}

// Visits the nodes that are not void, in order.
template <class Of>
Values by_material(const View& view, Of of) {
  const Lattice& lattice = view.lattice();
  Values values(lattice.grid.nodes());
  for (int j = 0; j < lattice.grid.ny; ++j)
    for (int i = 0; i < lattice.grid.nx; ++i)
      if (!lattice.is_void(i, j)) {
        const std::size_t node = lattice.grid.index(i, j);
        values[node] = static_cast<float>(of(node, lattice.material_at(i, j).material));
      }
  return values;
}

Values fringes(const View& view) {
  return fringes_of(view, stresses(view));
}

Values strengths(const View& view) {
  const std::vector<float>& strength = view.lattice().strength;
  return strength.empty() ? Values(view.lattice().grid.nodes(), 1.0F) : strength;
}

Values temperatures(const View& view) {
  const std::vector<double>& strain = view.thermal_strain();
  return by_material(view, [&](std::size_t node, const Material& material) {
    return strain.empty() || material.alphaT == 0.0 ? 0.0 : strain[node] / material.alphaT;
  });
}

constexpr std::array<Scalar, scalar_names.size()> all{{
    {"damage", "damage", "", "Share of a node's bonds that are broken.", "damage",
     Sampling::largest, false, fixed<0, 50>, damages},
    {"displacement", "displacement", "m", "How far a node has moved.", "viridis", Sampling::mean,
     false, share<critical_length, 0, 100>, part_of<displacement, Part::length>},
    {"displacement_x", "displacement x", "m", "Displacement along x.", "vik", Sampling::mean, false,
     share<critical_length, -100, 100>, part_of<displacement, Part::x>},
    {"displacement_y", "displacement y", "m", "Displacement along y.", "vik", Sampling::mean, false,
     share<critical_length, -100, 100>, part_of<displacement, Part::y>},
    {"speed", "speed", "m/s", "How fast a node moves.", "inferno", Sampling::mean, false,
     share<critical_speed, 0, 50>, part_of<velocity, Part::length>},
    {"velocity_x", "velocity x", "m/s", "Velocity along x.", "vik", Sampling::mean, false,
     share<critical_speed, -50, 50>, part_of<velocity, Part::x>},
    {"velocity_y", "velocity y", "m/s", "Velocity along y.", "vik", Sampling::mean, false,
     share<critical_speed, -50, 50>, part_of<velocity, Part::y>},
    {"stretch", "stretch/critical", "", "The bond of a node that is closest to breaking.",
     "inferno", Sampling::largest, false, fixed<0, 100>, closeness},
    {"energy_density", "energy", "J/m3", "Strain energy for each volume.", "inferno",
     Sampling::largest, true, ends_of_energy, energies},
    {"stress_xx", "stress xx", "Pa", "Normal stress along x.", "vik", Sampling::mean, false,
     share<critical_stress, -50, 50>, stress_part<&Stress::xx>},
    {"stress_yy", "stress yy", "Pa", "Normal stress along y.", "vik", Sampling::mean, false,
     share<critical_stress, -50, 50>, stress_part<&Stress::yy>},
    {"stress_xy", "stress xy", "Pa", "Shear stress.", "vik", Sampling::mean, false,
     share<critical_stress, -50, 50>, stress_part<&Stress::xy>},
    {"stress_1", "largest stress", "Pa", "The larger principal stress.", "vik", Sampling::mean,
     false, share<critical_stress, -50, 50>, stress_part<&Stress::first>},
    {"stress_2", "least stress", "Pa", "The smaller principal stress.", "vik", Sampling::mean,
     false, share<critical_stress, -50, 50>, stress_part<&Stress::second>},
    {"stress_mean", "mean stress", "Pa",
     "The mean of the principal stresses in the plane: above 0 it opens, below it presses.", "vik",
     Sampling::mean, false, share<critical_stress, -50, 50>, stress_part<mean_in_plane>},
    {"von_mises", "von Mises", "Pa", "Von Mises' stress, with that across the thickness.",
     "viridis", Sampling::mean, false, share<critical_stress, 0, 50>,
     stress_part<&Stress::von_mises>},
    {"shear", "largest shear", "Pa", "The most shear stress in any direction.", "viridis",
     Sampling::mean, false, share<critical_stress, 0, 25>, stress_part<&Stress::shear>},
    {"fringes", "fringes", "",
     "Isochromatics, as a polariscope with a dark field shows them; the bar counts them.",
     "fringes", Sampling::mean, false, ends_of_fringes, fringes},
    {"fragments", "fragment", "", "What hangs together, counted from the largest piece.", "batlow",
     Sampling::largest, false, fixed<0, 1200>, fragments},
    {"strength", "strength", "", "Critical stretch over that of the material.", "roma",
     Sampling::mean, false, fixed<50, 150>, strengths},
    {"temperature", "temperature change", "K", "Change of temperature.", "vik", Sampling::mean,
     false, ends_of_temperature, temperatures},
}};

static_assert(std::ranges::equal(all, scalar_names, {}, &Scalar::name));

}  // namespace

std::vector<float> fringes_of(const View& view, const std::vector<Stress>& stresses) {
  check_fringes(view.lattice());
  return by_material(view, [&](std::size_t node, const Material& material) {
    return 2.0 * stresses[node].shear() * fringes_per_stress(material);
  });
}

std::span<const Scalar> scalars() {
  return all;
}

const Scalar& scalar_of(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Scalar::name);
  if (found != all.end()) return *found;
  throw Error(
      ErrorKind::refused,
      fmt::format("there is no field '{}'{}", name.substr(0, 40), did_you_mean(name, scalar_names)),
      "one of " + comma_list(scalar_names));
}

void check_fringes(const Lattice& lattice) {
  Problems problems;
  for (const MaterialOnLattice& known : lattice.materials)
    if (known.material.fringe == 0.0)
      problems.add(fmt::format("fringes: {} has no fringe value", known.material.name),
                   "material { like = ..., fringe = ... } takes it, in N/m; duran50 and "
                   "homalite100 have one");
  problems.throw_if_any();
}

}  // namespace hackle
