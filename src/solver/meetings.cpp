// SPDX-License-Identifier: MIT
#include "solver/meetings.hpp"

#include <cstdint>
#include <map>

namespace hackle {
namespace {

constexpr std::uint8_t crowd = 3;

}  // namespace

std::vector<Meeting> find_meetings(const std::vector<const std::vector<std::size_t>*>& lists,
                                   std::size_t places) {
  if (lists.size() < crowd) return {};
  std::vector<std::uint8_t> count(places);
  for (const auto* list : lists)
    for (const std::size_t place : *list)
      if (count[place] < crowd) ++count[place];
  std::map<std::size_t, std::vector<Meeting::Entry>> found;
  for (std::size_t k = 0; k < lists.size(); ++k)
    for (std::size_t entry = 0; entry < lists[k]->size(); ++entry)
      if (const std::size_t place = (*lists[k])[entry]; count[place] == crowd)
        found[place].push_back({k, entry});
  std::vector<Meeting> meetings;
  meetings.reserve(found.size());
  for (auto& [place, entries] : found) meetings.push_back({place, std::move(entries)});
  return meetings;
}

}  // namespace hackle
