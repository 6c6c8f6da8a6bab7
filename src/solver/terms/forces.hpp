// SPDX-License-Identifier: MIT
// Tractions, pressures and body forces: forces whose places are known beforehand.
#pragma once

#include <vector>

#include "solver/meetings.hpp"
#include "solver/tabulated_amplitude.hpp"
#include "solver/tabulated_course.hpp"
#include "solver/terms/term.hpp"

namespace hackle {

class Forces final : public Term {
 public:
  Forces(const std::vector<SpreadForce>& forces, const Grid& grid);

  std::unique_ptr<Term> clone() const override { return std::make_unique<Forces>(*this); }
  std::string_view name() const override { return varies_ ? "varying loads" : ""; }
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) override;
  void begin(const Surroundings&, State&) override { fresh_ = true; }
  bool keeps_to_rows() const override { return true; }
  bool update(const Surroundings& around, State& state) override;
  std::span<const LoadedNode> forces() const override { return forces_; }
  bool varies() const override { return varies_; }
  void add_work(const Surroundings& around, const State& state, WorkOf part,
                double& work) const override;
  void halt(const Surroundings& around, const State& state, double passed) override;
  bool acts_at_rest() const override { return true; }
  std::size_t bytes() const override;

 private:
  // What one load adds to the entries of forces_.
  struct Part {
    std::vector<std::size_t> at;
    std::vector<Vec2> acceleration;  // m/s2
    TabulatedAmplitude amplitude;
    TabulatedCourse<Vec2> course;  // of the acceleration
  };

  void find_crowds();
  template <class Factor>
  void sum(const Factor& factor_of);

  std::vector<Part> parts_;
  std::vector<Meeting> crowds_;  // entries of forces_ with three or more parts
  std::vector<LoadedNode> forces_;
  bool varies_ = false;
  bool fresh_ = true;  // the loads differ from those of the last update()
};

// Adds the work of forces in a step, of which `state` is the end. v is the displacement of the
// step: the work of constant forces is exact, that of others of second order in the step.
void add_work_of(std::span<const LoadedNode> forces, const Surroundings& around, const State& state,
                 WorkOf part, double& work);

}  // namespace hackle
