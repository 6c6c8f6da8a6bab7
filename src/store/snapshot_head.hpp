// SPDX-License-Identifier: MIT
// What a snapshot holds beside the arrays of its state, as JSON: alike in checkpoints and in exact
// records of run files.
#pragma once

#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

#include "lattice/grid.hpp"
#include "solver/snapshot.hpp"

namespace hackle {

// Whether a member of a state is in the head: it does not grow with the plate.
template <class Member>
inline constexpr bool is_in_head =
    std::is_same_v<Member, std::int64_t> || std::is_same_v<Member, double> ||
    std::is_same_v<Member, Vec2> || std::is_same_v<Member, Clock> ||
    std::is_same_v<Member, std::vector<Disc>>;

nlohmann::json head_of(const Snapshot& snapshot);

// Sets all that head_of() tells, and the precision of the state, whose arrays are then empty.
// Throws std::exception for a head of another form, or with values that are not finite.
void read_head(const nlohmann::json& head, Snapshot& snapshot);

// Whether the nodes and bonds that the head names are those of the grid and the state.
bool names_only_its_own(const Snapshot& snapshot, const Grid& grid);

}  // namespace hackle
