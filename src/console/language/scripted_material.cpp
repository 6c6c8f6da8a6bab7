// SPDX-License-Identifier: MIT
#include "console/language/scripted_material.hpp"

#include <fmt/format.h>

#include "console/lua/description.hpp"
#include "console/session.hpp"

namespace hackle {

std::any read_material(const GivenValue& given) {
  if (const Material* material = object_at<Material>(given.L, given.index)) return *material;
  if (lua_type(given.L, given.index) != LUA_TSTRING) return given.wrong_type();
  try {
    return session_of(given.L).materials().find(text_at(given.L, given.index)).material;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused) throw;
    const Problem& problem = error.problems().front();
    return given.wrong(fmt::format("{}: {}", given.doc.name, problem.what), problem.remedy);
  }
}

}  // namespace hackle
