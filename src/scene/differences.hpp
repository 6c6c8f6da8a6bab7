// SPDX-License-Identifier: MIT
// The members in which two nouns that are described differ, by their path.
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "scene/wording.hpp"

namespace hackle {

// Entries of lists are counted from 1, as in scripts: {"tractions[2].stress", "(0 Pa, 12 MPa)", "(0
// Pa, 14 MPa)"}.
struct Difference {
  std::string path;
  std::string one, other;  // values in words, which differ; "none" for what is not there
};

template <class T>
inline constexpr bool is_list_of_nouns = false;
template <class T>
inline constexpr bool is_list_of_nouns<std::vector<T>> = Described<T> || std::is_same_v<T, Shape>;

// Collects all differences of two nouns, in the order of their members. A function of place or time
// that is described but not known (see Inputs) counts as equal to one with the same text.
class Differences {
 public:
  template <Described Noun>
  Differences(const Noun& one, const Noun& other) {
    compare_members(one, other, "");
  }
  const std::vector<Difference>& list() const& { return list_; }
  std::vector<Difference> list() && { return std::move(list_); }

 private:
  static constexpr std::size_t max_paired = 1000;  // entries of a list

  static std::string below(const std::string& path, std::string_view name) {
    return fmt::format("{}{}{}", path, path.empty() || name.empty() ? "" : ".", name);
  }

  template <class T>
  void compare(const T& one, const T& other, const std::string& path, const About& about) {
    if constexpr (std::is_same_v<T, Shape>)
      compare_shapes(one, other, path, about);
    else if constexpr (Described<T>)
      compare_members(one, other, path);
    else if constexpr (is_optional<T>)
      compare_optionals(one, other, path, about);
    else if constexpr (is_list_of_nouns<T>)
      compare_lists(one, other, path, about);
    else if (!same(one, other))
      add(one, other, path, about);
  }

  template <Described Noun>
  void compare_members(const Noun& one, const Noun& other, const std::string& path) {
    for_each_member<Noun>([&](const auto& member) {
      const auto &left = one.*member.pointer, &right = other.*member.pointer;
      if constexpr (requires { member.kind; }) {
        const auto kind = static_cast<std::size_t>(one.*member.kind);
        const auto other_kind = static_cast<std::size_t>(other.*member.kind);
        if (kind == other_kind)
          compare(left, right, below(path, member.names[kind]), member.abouts[kind]);
        else
          list_.push_back({below(path, member.names[kind]), Wording()(left, member.abouts[kind]),
                           fmt::format("{} {}", member.names[other_kind],
                                       Wording()(right, member.abouts[other_kind]))});
      } else {
        compare(left, right, below(path, member.name), member.about);
      }
    });
  }

  void compare_shapes(const Shape& one, const Shape& other, const std::string& path,
                      const About& about) {
    if (one.index() != other.index()) return add(one, other, path, about);
    std::visit(
        [&](const auto& kind) {
          compare_members(kind, std::get<std::remove_cvref_t<decltype(kind)>>(other), path);
        },
        one);
  }

  template <class T>
  void compare_optionals(const std::optional<T>& one, const std::optional<T>& other,
                         const std::string& path, const About& about) {
    if (one && other) return compare(*one, *other, path, about);
    if (one.has_value() != other.has_value()) add(one, other, path, about);
  }

  template <class T>
  void compare_lists(const std::vector<T>& one, const std::vector<T>& other,
                     const std::string& path, const About& about) {
    const std::vector<std::size_t> partners = partners_of(one, other);
    for (std::size_t k = 0; k < one.size(); ++k)
      if (partners[k] < other.size())
        compare(one[k], other[partners[k]], fmt::format("{}[{}]", path, k + 1), about);
      else
        list_.push_back({fmt::format("{}[{}]", path, k + 1), Wording()(one[k], about), "none"});
    std::vector<char> is_partner(other.size() + 1, 0);
    for (const std::size_t partner : partners) is_partner[partner] = 1;
    for (std::size_t k = 0; k < other.size(); ++k)
      if (is_partner[k] == 0)
        list_.push_back({fmt::format("{}[{}]", path, k + 1), "none", Wording()(other[k], about)});
  }

  // Returns the place in the other list of what each entry is compared with; its size for nothing.
  // The order of loads does not matter: equal ones are partners wherever they stand, and of the
  // others first those that act in the same place.
  template <class T>
  static std::vector<std::size_t> partners_of(const std::vector<T>& one,
                                              const std::vector<T>& other) {
    std::vector<std::size_t> partners(one.size(), other.size());
    std::vector<char> taken(other.size(), 0);
    const auto pair_up = [&](const auto& fits) {
      for (std::size_t k = 0; k < one.size(); ++k)
        for (std::size_t l = 0; partners[k] == other.size() && l < other.size(); ++l)
          if (taken[l] == 0 && fits(k, l)) partners[k] = l, taken[l] = 1;
    };
    // Every pair is looked at: not in a file that somebody has filled with loads.
    const bool few = one.size() <= max_paired && other.size() <= max_paired;
    if constexpr (requires(const T& load) { same_place(load, load); }) {
      if (few) pair_up([&](std::size_t k, std::size_t l) { return same(one[k], other[l]); });
      if (few) pair_up([&](std::size_t k, std::size_t l) { return same_place(one[k], other[l]); });
      if (few) pair_up([](std::size_t, std::size_t) { return true; });
      if (few) return partners;
    }
    for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) partners[k] = k;
    return partners;
  }

  // In more digits where four do not tell them apart. Values that even then read alike, such as
  // functions, which a file cannot hold, count as equal.
  template <class T>
  void add(const T& one, const T& other, const std::string& path, const About& about) {
    for (const Wording::Digits digits : {Wording::Digits::four, Wording::Digits::all}) {
      const Wording words(digits);
      Difference found{path, words(one, about), words(other, about)};
      if (found.one == found.other) continue;
      list_.push_back(std::move(found));
      return;
    }
  }

  std::vector<Difference> list_;
};

}  // namespace hackle
