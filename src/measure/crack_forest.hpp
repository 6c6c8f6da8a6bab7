// SPDX-License-Identifier: MIT
// The nodes on cracks as trees: each node hangs on the one from which the crack came to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/union_find.hpp"
#include "measure/crack_growth.hpp"

namespace hackle {

// Two cracks that grew apart and then met.
struct Meeting {
  std::size_t one = 0, other = 0;  // nodes by Grid::index, one of each
  double time = 0.0;               // s
};

// Returns the mean damage of a node and its eight neighbours.
double mean_damage(const CrackGrowth& growth, int i, int j);

class CrackForest {
 public:
  // Plants and grows all trees in the order of arrival. Within one moment a path goes where damage
  // is most. A tree shorter than a horizon becomes part of the one that it meets.
  explicit CrackForest(const CrackGrowth& growth);

  struct Tree {
    double min_x = 0.0, max_x = 0.0, min_y = 0.0, max_y = 0.0;  // dx
    std::vector<int> members;
    bool at_start = false;  // a crack of the scene
    double extent() const;
  };

  // Nodes by their place in CrackGrowth::nodes().
  std::size_t size() const { return places_.size(); }
  int parent(int node) const { return parent_[at(node)]; }         // -1: a root
  double way(int node) const { return way_[at(node)]; }            // dx, from the root
  double strength(int node) const { return strength_[at(node)]; }  // mean damage around it
  Vec2 place(int node) const { return places_[at(node)]; }         // dx, from the centre
  const Tree& tree(int node) const { return trees_[static_cast<std::size_t>(tree_[at(node)])]; }
  const std::vector<Meeting>& meetings() const { return meetings_; }
  // Returns the node at a place of the lattice, or -1.
  int at_place(int i, int j) const;

 private:
  struct Link {
    int a, b;
    double length;
  };
  static std::size_t at(int node) { return static_cast<std::size_t>(node); }

  void grow(std::size_t first, std::size_t end);
  void spread(const std::vector<int>& from);
  void relax_from_neighbours(int node, std::vector<int>& reached);
  bool relax(int node, int from, double length);
  std::vector<int> connected(int node);
  void plant(int node);
  int sweep(int root, const std::vector<int>& members);
  int root_of(const std::vector<int>& members);
  void set_tree(int node, int tree);
  void meet(std::size_t first, std::size_t end);
  void absorb(int tree);
  template <class Visit>
  void for_neighbours(int node, Visit visit) const;

  const CrackGrowth* growth_;
  std::vector<Link> links_;
  std::vector<std::int32_t> index_;  // by Grid::index
  std::vector<Vec2> places_;
  std::vector<double> strength_, way_, cost_;
  std::vector<int> parent_, tree_;
  std::vector<char> grown_, open_;
  std::vector<Tree> trees_;
  std::vector<Meeting> meetings_;
  std::vector<std::vector<int>> met_;  // trees
};

}  // namespace hackle
