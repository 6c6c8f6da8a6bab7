// SPDX-License-Identifier: MIT
#include "console/language/scripted_plate.hpp"

#include "console/session.hpp"

namespace hackle {

int return_plate(lua_State* L) {
  const Plate* plate = object_at<Plate>(L, 1);
  PlateMemory& known = session_of(L).plates[plate];
  PlateMemory grown = known;
  hold_memory(L, grown.grown(*plate));
  known = grown;
  lua_settop(L, 1);
  return 1;
}

int destroy_plate(lua_State* L) {
  const Plate* plate = object_at<Plate>(L, 1);
  if (plate == nullptr) return 0;
  const auto node = session_of(L).plates.extract(plate);
  if (!node.empty()) release_memory(L, node.mapped().total());
  return destroy_object<Plate>(L);
}

}  // namespace hackle
