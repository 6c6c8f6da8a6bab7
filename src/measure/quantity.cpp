// SPDX-License-Identifier: MIT
#include "measure/quantity.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "measure/heading.hpp"
#include "measure/scalar.hpp"
#include "scene/load_names.hpp"

namespace hackle {
namespace {

using Number = std::optional<double>;

template <double Energy::*part>
Number energy_part(Glance& glance) {
  return glance.energy().*part;
}

template <double Ledger::*part>
Number ledger_part(Glance& glance) {
  return glance.ledger().*part;
}

template <int axis>
Number tip(Glance& glance) {
  const std::optional<Vec2> place = glance.cracks().tip();
  return place ? Number((*place)[axis]) : std::nullopt;
}

template <auto part>
Number fracture_part(Glance& glance) {
  const std::optional<Fracture>& found = glance.fracture();
  return found ? Number(((*found).*part)()) : std::nullopt;
}

constexpr QuantityKind usual{.usual = true}, usual_and_dear{.usual = true, .dear = true};

constexpr auto quantity_list = std::to_array<Quantity>({
    {"time", "s", "Simulated time, that of the row.", usual,
     [](Glance& glance) -> Number { return glance.view().time(); }},
    {"step", "", "Time steps done.", usual,
     [](Glance& glance) -> Number { return static_cast<double>(glance.view().state().step); }},
    {"external",
     "J/m",
     "Work of loads, supports and heat; with supports a look at every bond.",
     {.usual = true, .recorded = false},
     ledger_part<&Ledger::external>},
    {"kinetic", "J/m", "Kinetic energy; a look at every bond.", usual_and_dear,
     energy_part<&Energy::kinetic>},
    {"strain", "J/m", "Energy of intact bonds; a look at each.", usual_and_dear,
     energy_part<&Energy::strain>},
    {"broken", "J/m", "Energy of the bonds broken since the start.", usual,
     [](Glance& glance) -> Number { return glance.cracks().broken_energy(); }},
    {"damped",
     "J/m",
     "Energy that damping and friction have taken.",
     {.recorded = false},
     ledger_part<&Ledger::damped>},
    {"released",
     "J/m",
     "Energy set free on the way to rest.",
     {.recorded = false},
     ledger_part<&Ledger::released>},
    {"contact", "J/m", "Energy in contacts.", {.recorded = false}, ledger_part<&Ledger::contact>},
    {"residual",
     "J/m",
     "What the ledger lacks; a look at every bond.",
     {.dear = true, .recorded = false},
     [](Glance& glance) -> Number { return glance.energy().residual(); }},
    {"bonds", "", "Bonds broken since the start.", usual,
     [](Glance& glance) -> Number { return static_cast<double>(glance.cracks().broken_bonds()); }},
    {"damage", "", "Largest damage of a node.", usual,
     [](Glance& glance) -> Number { return glance.cracks().max_damage(); }},
    {"crack.length", "m",
     "Length of new cracks: the energy of the broken bonds over G0, which is that of a straight "
     "crack along an axis.",
     usual, [](Glance& glance) -> Number { return glance.cracks().length(); }},
    {"tip.x", "m",
     "Place of the node on a crack (damage above 0.35) that lies farthest along `along`; the "
     "middle "
     "of several. Empty without a crack.",
     usual, tip<0>},
    {"tip.y", "m", "The same along y.", usual, tip<1>},
    {"tip.speed", "m/s",
     "Speed of the tip along `along`: its way over the time that its last two horizons took.",
     usual, [](Glance& glance) -> Number { return glance.cracks().speed(); }},
    {"tip.energy",
     "J/m2",
     "Energy of broken bonds per length of the way of the tip, over its last two horizons: G0 for "
     "one straight crack, more where the crack frays or forks. Empty before it moves.",
     {},
     [](Glance& glance) -> Number { return glance.cracks().energy_per_length(); }},
    {"J",
     "J/m2",
     "Mean of J over rings around the tip, as s:fracture tells it; empty without.",
     {.dear = true},
     fracture_part<&Fracture::J>},
    {"K_I",
     "Pa sqrt(m)",
     "Stress intensity of opening there, by the interaction integral.",
     {.dear = true},
     fracture_part<&Fracture::K_I>},
    {"K_II", "Pa sqrt(m)", "The same of sliding.", {.dear = true}, fracture_part<&Fracture::K_II>},
    {"fragments",
     "",
     "Number of fragments; a look at every bond.",
     {.dear = true},
     [](Glance& glance) -> Number { return static_cast<double>(glance.fragments().all.size()); }},
    {"fragments.largest",
     "m2",
     "Area of the largest fragment.",
     {.dear = true},
     [](Glance& glance) -> Number {
       const auto& all = glance.fragments().all;
       return all.empty() ? 0.0 : all.front().area;
     }},
    {"fragments.median",
     "m2",
     "Area of the fragment up to which, from the smallest on, half of the area lies.",
     {.dear = true},
     [](Glance& glance) -> Number { return glance.fragments().median_area(); }},
    {"fragments.dust",
     "m2",
     "Area of the nodes that have lost all bonds.",
     {.dear = true},
     [](Glance& glance) -> Number { return glance.fragments().dust; }},
});

struct LoadValue {
  PartQuantity named;
  bool usual;
  double (*value)(const Reaction&);
};

constexpr auto load_values = std::to_array<LoadValue>({
    {{"fx", "N/m", "Force of the plate on it along x, per metre of thickness."},
     true,
     [](const Reaction& one) { return one.force.x(); }},
    {{"fy", "N/m", "The same along y."}, true, [](const Reaction& one) { return one.force.y(); }},
    {{"moment", "N", "Moment of these forces about the lower left corner, anticlockwise."},
     false,
     [](const Reaction& one) { return one.moment; }},
    {{"ux", "m", "Its way along x: of a body, or the mean of its nodes."},
     true,
     [](const Reaction& one) { return one.moved.x(); }},
    {{"uy", "m", "The same along y."}, true, [](const Reaction& one) { return one.moved.y(); }},
    {{"x", "m", "Its place: the centre of a body, or the mean of its nodes."},
     false,
     [](const Reaction& one) { return one.centre.x(); }},
    {{"y", "m", "The same along y."}, false, [](const Reaction& one) { return one.centre.y(); }},
});
// Of every load that has an amplitude.
constexpr PartQuantity factor{"factor", "", "Amplitude of the load at this time."};

constexpr auto field_quantity_list = std::to_array<PartQuantity>({
    {"max", "", "Largest value of a field of pictures, as \"max.stress_1\"; a look at every bond."},
    {"min", "", "Smallest value of a field."},
    {"mean", "", "Mean of a field over the nodes of the plate."},
});

// Returns the load of that name that bears the plate, or nothing: loads may come and go.
const Reaction* reaction_named(Glance& glance, const std::string& name) {
  const std::vector<Reaction>& all = glance.reactions();
  const auto found = std::ranges::find(all, name, &Reaction::name);
  return found == all.end() ? nullptr : &*found;
}

Column load_column(const std::string& load, const LoadValue& part) {
  return {fmt::format("{}.{}", load, part.named.name), std::string(part.named.unit),
          [load, value = part.value](Glance& glance) -> Number {
            const Reaction* found = reaction_named(glance, load);
            return found == nullptr ? std::nullopt : Number(value(*found));
          }};
}

Column factor_column(const std::string& load) {
  return {fmt::format("{}.{}", load, factor.name), "", [load](Glance& glance) -> Number {
            for (const LoadName& one : load_names(glance.view().plate().loads))
              if (one.name == load && one.amplitude != nullptr)
                return one.amplitude->at(glance.view().time());
            return std::nullopt;
          }};
}

bool bears(std::string_view kind) {
  constexpr auto kinds =
      std::to_array<std::string_view>({"support", "impactor", "roller", "platen", "foundation"});
  return std::ranges::find(kinds, kind) != kinds.end();
}

// Returns every column of the loads of a plate that is solved.
std::vector<Column> load_columns(const Loads& loads) {
  std::vector<Column> all;
  for (const LoadName& load : load_names(loads)) {
    if (bears(load.kind))
      for (const LoadValue& part : load_values) all.push_back(load_column(load.name, part));
    if (load.amplitude != nullptr) all.push_back(factor_column(load.name));
  }
  return all;
}

// Of the nodes that are there: a hole has no stress.
Number over_plate(Glance& glance, std::string_view field, std::string_view how) {
  const Lattice& lattice = glance.view().lattice();
  const std::vector<float>& values = glance.field(field);
  std::optional<double> min, max;
  double sum = 0.0, count = 0.0;
  for (std::size_t node = 0; node < values.size(); ++node) {
    if (!lattice.material.empty() && lattice.material[node] == Lattice::void_node) continue;
    const double value = values[node];
    min = std::min(min.value_or(value), value);
    max = std::max(max.value_or(value), value);
    sum += value;
    count += 1.0;
  }
  if (how == "mean") return count > 0.0 ? Number(sum / count) : std::nullopt;
  return how == "max" ? max : min;
}

Column field_column(const Scalar& field, std::string_view how) {
  return {fmt::format("{}.{}", how, field.name), std::string(field.unit),
          [&field, how](Glance& glance) { return over_plate(glance, field.name, how); }};
}

std::vector<Column> field_columns() {
  std::vector<Column> all;
  for (const PartQuantity& how : field_quantity_list)
    for (const Scalar& field : scalars()) all.push_back(field_column(field, how.name));
  return all;
}

Column column_of(const Quantity& one) {
  return {std::string(one.name), std::string(one.unit), one.value};
}

std::vector<Column> all_columns(const View& view, bool of_run) {
  std::vector<Column> all;
  for (const Quantity& one : quantities())
    if (of_run || one.kind.recorded) all.push_back(column_of(one));
  const auto add = [&](std::vector<Column> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
  };
  if (of_run) add(load_columns(view.plate().loads));
  add(field_columns());
  return all;
}

}  // namespace

const Energy& Glance::energy() {
  if (!energy_) energy_ = hackle::energy(*view_);
  return *energy_;
}

const Ledger& Glance::ledger() {
  if (!ledger_) ledger_ = view_->at_step().ledger();
  return *ledger_;
}

const std::vector<Reaction>& Glance::reactions() {
  if (!reactions_) reactions_ = run_ != nullptr ? run_->reactions() : std::vector<Reaction>();
  return *reactions_;
}

const std::vector<float>& Glance::field(std::string_view name) {
  if (field_name_ != name) {
    field_ = scalar_of(name).values(*view_);
    field_name_ = name;
  }
  return field_;
}

const FragmentList& Glance::fragments() {
  if (!fragments_) fragments_ = measured_fragments(*view_);
  return *fragments_;
}

const std::optional<Fracture>& Glance::fracture() {
  if (!fracture_)
    fracture_ = fracture_if_any(*view_, {.along = cracks_->direction(), .who = "log"});
  return *fracture_;
}

std::span<const Quantity> quantities() {
  return quantity_list;
}
std::span<const PartQuantity> load_quantities() {
  static const std::vector<PartQuantity> list = [] {
    std::vector<PartQuantity> all;
    all.reserve(std::size(load_values) + 1);
    for (const LoadValue& one : load_values) all.push_back(one.named);
    all.push_back(factor);
    return all;
  }();
  return list;
}
std::span<const PartQuantity> field_quantities() {
  return field_quantity_list;
}

Column column_named(std::string_view name, const View& view, bool of_run, const std::string& who) {
  std::vector<Column> known = all_columns(view, of_run);
  const auto found = std::ranges::find(known, name, &Column::name);
  if (found != known.end()) {
    if (name.ends_with(fringes_name)) check_fringes(view.lattice());
    return std::move(*found);
  }
  const auto solved = all_columns(view, true);
  if (!of_run && std::ranges::find(solved, name, &Column::name) != solved.end())
    throw Error(ErrorKind::refused, fmt::format("{}: a recording does not know '{}'", who, name),
                "ask for it while the plate is solved, in s:log");
  std::vector<std::string_view> names;
  names.reserve(known.size());
  for (const Column& column : known) names.push_back(column.name);
  throw Error(ErrorKind::refused,
              fmt::format("{}: there is no column '{}'{}", who, name, did_you_mean(name, names)),
              "help \"columns\" lists them");
}

std::vector<Column> usual_columns(const View& view, bool of_run, bool cheap) {
  const Loads& loads = view.plate().loads;
  std::vector<Column> all;
  for (const Quantity& one : quantities()) {
    const bool dear = one.kind.dear || (one.name == "external" && !loads.supports.empty());
    if (one.kind.usual && (of_run || one.kind.recorded) && !(cheap && dear))
      all.push_back(column_of(one));
  }
  if (!of_run) return all;
  for (const LoadName& load : load_names(loads)) {
    const bool body = load.kind != "support" && load.kind != "foundation";
    if (!bears(load.kind) || !(body || load.is_given)) continue;
    for (const LoadValue& part : load_values)
      if (part.usual) all.push_back(load_column(load.name, part));
  }
  return all;
}

std::string heading_of(const Column& column) {
  return heading_of(column.name, column.unit);
}

}  // namespace hackle
