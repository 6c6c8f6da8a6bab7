// SPDX-License-Identifier: MIT
// What can be said of a plate by one number at a moment: the columns of tables.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/crack_track.hpp"
#include "measure/energy.hpp"
#include "measure/fracture.hpp"
#include "measure/fragment_list.hpp"
#include "solver/reaction.hpp"
#include "solver/view.hpp"

namespace hackle {

// A plate at the moment of one row. What several columns share is found once, when the first asks.
class Glance {
 public:
  // `run` is the simulation of the view, or null where it is one of a recording. Everything must
  // outlive the glance.
  Glance(const View& view, const CrackTrack& cracks, const Simulation* run)
      : view_(&view), cracks_(&cracks), run_(run) {}

  const View& view() const { return *view_; }
  const CrackTrack& cracks() const { return *cracks_; }
  const Simulation* run() const { return run_; }
  const Energy& energy();
  const Ledger& ledger();
  const std::vector<Reaction>& reactions();
  const std::vector<float>& field(std::string_view name);  // a field of pictures
  const FragmentList& fragments();
  // Of the tip of the cracks; nothing where it cannot be measured.
  const std::optional<Fracture>& fracture();

 private:
  const View* view_;
  const CrackTrack* cracks_;
  const Simulation* run_;
  std::optional<Energy> energy_;
  std::optional<Ledger> ledger_;
  std::optional<std::vector<Reaction>> reactions_;
  std::optional<FragmentList> fragments_;
  std::optional<std::optional<Fracture>> fracture_;
  std::string field_name_;
  std::vector<float> field_;
};

// Nothing where there is none, as the place of a tip without a crack.
using ValueOfGlance = std::function<std::optional<double>(Glance&)>;

struct Column {
  std::string name;  // "tip.x"
  std::string unit;  // SI; "" for none
  ValueOfGlance value;
};

struct QuantityKind {
  bool usual = false;    // a table without named columns has it
  bool dear = false;     // it takes a look at every bond
  bool recorded = true;  // a recording knows it, too
};

// A column that every plate has.
struct Quantity {
  std::string_view name;
  std::string_view unit;
  std::string_view sentence;  // for help
  QuantityKind kind;
  std::optional<double> (*value)(Glance&) = nullptr;
};
std::span<const Quantity> quantities();

// The quantities of a load, as "grip.fx", and of a field, as "max.stress_1": a first part and a
// second one.
struct PartQuantity {
  std::string_view name;  // "fx"
  std::string_view unit;
  std::string_view sentence;
};
std::span<const PartQuantity> load_quantities();
std::span<const PartQuantity> field_quantities();

// Returns the column of this name; `of_run` says whether it is of a plate that is solved. Throws
// Error (refused), in the name of `who`, with the nearest name, for one that is unknown or that a
// recording does not know.
Column column_named(std::string_view name, const View& view, bool of_run, const std::string& who);

// Returns the columns of a table in which none is named, with the forces of bodies and of loads
// that were given a name; `cheap` ones look at no bond but those that break and those of supports
// with a name.
std::vector<Column> usual_columns(const View& view, bool of_run, bool cheap);

// See heading.hpp.
std::string heading_of(const Column& column);

}  // namespace hackle
