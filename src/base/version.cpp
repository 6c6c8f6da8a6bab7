// SPDX-License-Identifier: MIT
#include "base/version.hpp"

#include "git_hash.hpp"  // written by git_hash.cmake at every build

namespace hackle {

std::string_view version() {
  return HACKLE_VERSION;
}
std::string_view git_hash() {
  return HACKLE_GIT_HASH;
}
std::string_view compiler() {
  return HACKLE_COMPILER;
}

}  // namespace hackle
