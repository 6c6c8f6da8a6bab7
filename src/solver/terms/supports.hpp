// SPDX-License-Identifier: MIT
// Nodes that are clamped or moved: they go where they are told, and no force changes that.
#pragma once

#include <string>
#include <vector>

#include "solver/tabulated_amplitude.hpp"
#include "solver/tabulated_course.hpp"
#include "solver/terms/term.hpp"

namespace hackle {

class Supports final : public Term {
 public:
  // `names` are those of the supports.
  Supports(const std::vector<SpreadSupport>& supports, const std::vector<std::string>& names,
           const Lattice& lattice, double dt);

  std::unique_ptr<Term> clone() const override { return std::make_unique<Supports>(*this); }
  std::string_view name() const override { return "varying loads"; }
  void tabulate(const Clock& clock, std::int64_t begin, std::int64_t end, double dt) override;
  bool keeps_to_rows() const override { return true; }
  bool update(const Surroundings& around, State& state) override;
  std::span<const PrescribedNode> prescribed() const override { return prescribed_; }
  bool varies() const override { return true; }
  void add_work(const Surroundings& around, const State& state, WorkOf part,
                double& work) const override;
  // The work of supports in the second half of the last step: they balance all forces on prescribed
  // nodes (src/solver/README.md 3.5).
  void add_open(const Surroundings& around, const State& state, Ledger& ledger) const override;
  void halt(const Surroundings& around, const State& state, double passed) override;
  bool acts_at_rest() const override { return true; }
  // What a support bears is what it keeps its nodes from doing (src/solver/README.md 3.10).
  void add_reactions(const Surroundings& around, const State& state,
                     std::vector<Reaction>& list) const override;
  std::size_t bytes() const override;

 private:
  struct Part {
    std::vector<std::size_t> at;  // in prescribed_
    std::vector<Vec2> value;      // in units of dx: of u, or of its change per step
    bool along_x, along_y;
    Support::Kind kind;
    TabulatedAmplitude amplitude;
    TabulatedCourse<Vec2> course;  // of the value, m or m/s
    double unit;                   // of the value, per m or m/s
    std::string name;
  };
  // The supports that hold a node, as positions in parts_; -1 for none.
  struct Holders {
    int along_x = -1;
    int along_y = -1;
  };

  void add(const SpreadSupport& support, const std::string& name,
           const std::vector<std::size_t>& all, const Lattice& lattice, double dt);
  template <class Values>
  void follow_courses(const Values& values_of);
  template <class Factor>
  void prescribe(const State& state, const Factor& factor_of);

  std::vector<Part> parts_;
  std::vector<PrescribedNode> prescribed_;
  std::vector<Holders> holders_;  // of each of them
};

}  // namespace hackle
