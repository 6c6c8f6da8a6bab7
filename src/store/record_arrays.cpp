// SPDX-License-Identifier: MIT
#include "store/record_arrays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "measure/field.hpp"
#include "measure/scalar.hpp"

namespace hackle {
namespace {

template <class Number>
void require_finite(std::string_view name, const std::vector<Number>& values) {
  for (const Number value : values)
    if (!std::isfinite(value))
      throw Error(ErrorKind::run_failed,
                  fmt::format("record: the {} is not a finite number everywhere", name),
                  "take a smaller step");
}

// Hands the arrays of one record to a visitor.
class ArraysOfRecord {
 public:
  ArraysOfRecord(const Simulation& simulation, const RecordContents& contents,
                 const std::function<void(const RecordArray&)>& visit)
      : simulation_(simulation), contents_(contents), visit_(visit) {}

  void fields() const {
    if (contents_.holds("damage"))
      field(damage(simulation_), "share of a node's initial bonds that are broken");
    if (contents_.holds("displacement")) displacements();
    if (contents_.holds("velocity")) velocities();
    for (const std::string& name : contents_.fields)
      if (std::ranges::find(usual_records, name) == usual_records.end()) scalar(scalar_of(name));
  }

  // What the bonds are, and the rigid bodies.
  void bonds() const {
    const auto words = static_cast<hsize_t>(simulation_.lattice().family.words());
    visit_({"broken",
            "",
            "bits of the kept bonds of a node that have broken since the start",
            {grid().nodes(), words},
            words,
            broken_bonds()});
    if (const std::vector<double>& strain = simulation_.thermal_strain(); !strain.empty())
      visit_({"thermal_strain",
              "",
              "thermal strain",
              {grid().nodes()},
              1,
              std::vector<float>(strain.begin(), strain.end())});
  }

  void bodies() const {
    const View view = simulation_.view();
    const State& state = view.state();
    const Loads& loads = simulation_.plate().loads;
    const auto radius = [](const auto& body) { return std::array{body.radius}; };
    const auto half = [](const Platen& platen) {
      const Vec2 size = 0.5 * (platen.to - platen.from).cwiseAbs();
      return std::array{size.x(), size.y()};
    };
    bodies("discs", "impactor", "radius", bodies_at(state.discs, loads.impactors, radius), 5);
    bodies("rollers", "roller", "radius", bodies_at(state.rollers, loads.rollers, radius), 5);
    bodies("platens", "platen", "half of width and height",
           bodies_at(state.platens, loads.platens, half), 6);
  }

  void state() const {
    std::visit(
        [&](const auto& motion) {
          for_each_array([&](const char* name, const auto& values) { state_array(name, values); },
                         motion);
        },
        simulation_.state().motion);
  }

 private:
  const Grid& grid() const { return simulation_.lattice().grid; }

  // Picks the nodes of the record out of values by Grid::index.
  template <class Number>
  std::vector<Number> picked(const std::vector<Number>& values, std::size_t components) const {
    std::vector<Number> list;
    list.reserve(components * contents_.nodes.nodes());
    contents_.nodes.for_each([&](int i, int j) {
      const auto first =
          values.begin() + static_cast<std::ptrdiff_t>(components * grid().index(i, j));
      list.insert(list.end(), first, first + static_cast<std::ptrdiff_t>(components));
    });
    return list;
  }

  // A field that ParaView shows; vectors need three components.
  void field(const Field& field, const std::string& long_name) const {
    require_finite(field.name, field.values);
    const auto components = static_cast<std::size_t>(field.components);
    array(field.name, field.unit, long_name, picked(field.values, components), components);
  }

  template <class Number>
  void array(const std::string& name, const std::string& unit, const std::string& long_name,
             std::vector<Number> values, std::size_t components) const {
    std::vector<hsize_t> shape{contents_.nodes.nodes()};
    if (components > 1) shape.push_back(3);
    visit_({name, unit, long_name, std::move(shape), components, std::move(values)});
  }

  void displacements() const {
    constexpr const char* meaning = "displacement of the nodes";
    if (!contents_.exact) return field(displacement(simulation_), meaning);
    const View view = simulation_.view();
    std::vector<double> values;
    values.reserve(2 * contents_.nodes.nodes());
    contents_.nodes.for_each([&](int i, int j) {
      const Vec2 u = view.lattice().is_void(i, j) ? Vec2(0, 0) : view.displacement(i, j);
      values.insert(values.end(), {u.x(), u.y()});
    });
    require_finite("displacement", values);
    array("displacement", "m", meaning, std::move(values), 2);
  }

  void velocities() const {
    constexpr const char* meaning = "velocity of the nodes";
    if (!contents_.exact) return field(velocity(simulation_), meaning);
    const std::vector<Vec2> all = simulation_.velocities();
    std::vector<double> values;
    values.reserve(2 * contents_.nodes.nodes());
    contents_.nodes.for_each([&](int i, int j) {
      const Vec2& v = all[grid().index(i, j)];
      values.insert(values.end(), {v.x(), v.y()});
    });
    require_finite("velocity", values);
    array("velocity", "m/s", meaning, std::move(values), 2);
  }

  void scalar(const Scalar& scalar) const {
    const std::string name(scalar.name);
    std::vector<float> values = picked(scalar.values(simulation_), 1);
    require_finite(name, values);
    array(name, std::string(scalar.unit), std::string(scalar.label), std::move(values), 1);
  }

  // Returns the bonds broken since the start as bits, node by node, the words of each together.
  std::vector<std::uint32_t> broken_bonds() const {
    const BondBits &initial = simulation_.lattice().bonds, &now = simulation_.state().bonds;
    const auto words = static_cast<std::size_t>(simulation_.lattice().family.words());
    std::vector<std::uint32_t> broken;
    broken.reserve(words * grid().nodes());
    for (int j = 0; j < grid().ny; ++j)
      for (int i = 0; i < grid().nx; ++i) {
        auto at = static_cast<std::size_t>(grid().layout().at(i, j));
        for (std::size_t word = 0; word < words; ++word, at += initial.plane())
          broken.push_back(initial.words()[at] & ~now.words()[at]);
      }
    return broken;
  }

  // Returns position (m) and velocity (m/s) of each rigid body, and the size (m) that size_of(body)
  // gives: one number or two.
  template <class Body, class SizeOf>
  std::vector<double> bodies_at(const std::vector<Disc>& places, const std::vector<Body>& bodies,
                                const SizeOf& size_of) const {
    std::vector<double> list;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Vec2 place = grid().centre + grid().dx * places[k].centre;
      const Vec2 velocity = grid().dx / simulation_.dt() * places[k].velocity;
      list.insert(list.end(), {place.x(), place.y(), velocity.x(), velocity.y()});
      for (const double size : size_of(bodies[k])) list.push_back(size);
    }
    return list;
  }

  void bodies(const char* name, const char* body, const char* size, std::vector<double> list,
              hsize_t columns) const {
    if (list.empty()) return;
    const std::string meaning =
        fmt::format("of each {}: position x and y (m), velocity x and y (m/s), {} (m)", body, size);
    const hsize_t rows = list.size() / columns;
    visit_({name, "", meaning, {rows, columns}, columns, std::move(list)});
  }

  // All nodes of an array of the state, without its ghosts.
  template <class Real>
  void state_array(const char* name, const Values<Real>& values) const {
    if (values.empty()) return;
    std::vector<Real> list;
    list.reserve(grid().nodes());
    for (int j = 0; j < grid().ny; ++j) {
      const auto row = values.begin() + grid().layout().at(0, j);
      list.insert(list.end(), row, row + grid().nx);
    }
    visit_({name,
            "",
            "of the state to the last bit, in units of the lattice: u/dx, v dt/dx",
            {grid().nodes()},
            1,
            std::move(list)});
  }

  const Simulation& simulation_;
  const RecordContents& contents_;
  const std::function<void(const RecordArray&)>& visit_;
};

}  // namespace

std::size_t RecordArray::size() const {
  return std::visit([](const auto& list) { return list.size(); }, values);
}

double RecordArray::value(std::size_t at) const {
  return std::visit([at](const auto& list) { return static_cast<double>(list[at]); }, values);
}

void for_each_dataset(const Simulation& simulation, const RecordContents& contents, bool with_state,
                      const std::function<void(const RecordArray&)>& visit) {
  const ArraysOfRecord arrays(simulation, contents, visit);
  arrays.fields();
  if (with_state || contents.holds("bonds")) arrays.bonds();
  arrays.bodies();
  if (with_state) arrays.state();
}

}  // namespace hackle
