// SPDX-License-Identifier: MIT
#include "console/language/overlay_options.hpp"

#include <optional>

#include <fmt/format.h>

#include "console/lua/description.hpp"

namespace hackle {
namespace {

// Reads {x, y, "label"}; returns nothing for any other value.
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

OverlayOptions overlay_of(const Arguments& arguments) {
  OverlayOptions overlay;
  if (arguments.has("title")) overlay.title = arguments.text("title");
  overlay.clock = arguments.flag("clock", overlay.clock);
  overlay.bar = arguments.flag("bar", overlay.bar);
  overlay.scale_bar = arguments.flag("scale_bar", overlay.scale_bar);
  overlay.load_curve = arguments.flag("load_curve", overlay.load_curve);
  overlay.energy = arguments.flag("energy", overlay.energy);
  overlay.markers = arguments.get<std::vector<Marker>>("markers", {});
  return overlay;
}

}  // namespace hackle
