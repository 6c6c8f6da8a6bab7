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
    const auto entry = [&](const std::vector<T>& list, std::size_t k) {
      return k < list.size() ? Wording()(list[k], about) : std::string("none");
    };
    for (std::size_t k = 0; k < std::max(one.size(), other.size()); ++k) {
      const std::string at = fmt::format("{}[{}]", path, k + 1);
      if (k < one.size() && k < other.size())
        compare(one[k], other[k], at, about);
      else
        list_.push_back({at, entry(one, k), entry(other, k)});
    }
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
