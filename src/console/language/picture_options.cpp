// SPDX-License-Identifier: MIT
#include "console/language/picture_options.hpp"

#include <optional>

#include <fmt/format.h>

#include "console/lua/description.hpp"

namespace hackle {
namespace {

// {x, y, "label"}, or nothing when it is anything else.
std::optional<Marker> marker_at(lua_State* L, int index) {
  if (lua_type(L, index) != LUA_TTABLE || entries(L, index) != 3) return std::nullopt;
  const bool typed = lua_rawgeti(L, index, 1) == LUA_TNUMBER &&
                     lua_rawgeti(L, index, 2) == LUA_TNUMBER &&
                     lua_rawgeti(L, index, 3) == LUA_TSTRING;
  std::optional<Marker> marker;
  if (typed) {
    const std::string_view label = text_at(L, -1);
    marker = Marker{{lua_tonumber(L, -3), lua_tonumber(L, -2)}, std::string(label)};
    if (!marker->place.allFinite() || label.find('\0') != std::string_view::npos) marker.reset();
  }
  lua_settop(L, index);
  return marker;
}

}  // namespace

std::any read_markers(const GivenValue& given) {
  lua_State* L = given.L;
  if (!given.is_list()) return {};
  std::vector<Marker> markers;
  for (lua_Unsigned k = 1; k <= lua_rawlen(L, given.index); ++k) {
    lua_rawgeti(L, given.index, static_cast<lua_Integer>(k));
    const std::optional<Marker> marker = marker_at(L, lua_gettop(L));
    lua_pop(L, 1);
    if (!marker)
      return given.wrong(fmt::format(
          "{}: entry {} of {} is not {{x, y, \"label\"}}, two finite numbers and a text",
          given.doc.name, k, given.option.name));
    markers.push_back(*marker);
  }
  return markers;
}

void read_given(const Arguments& arguments, std::string_view name, const About&, Ends& ends) {
  const Vec2 range = arguments.pair(name);
  ends = {range.x(), range.y()};
}

void read_given(const Arguments& arguments, std::string_view name, const About&, Zoom& zoom) {
  const Eigen::Vector3d window = arguments.window(name);
  zoom = {window.head<2>(), window.z()};
}

}  // namespace hackle
