// SPDX-License-Identifier: MIT
#include "app/libraries.hpp"

#include <Eigen/Core>
#include <cairo.h>
#include <fmt/format.h>
#include <lua.hpp>
#include <oneapi/tbb/version.h>

#include "movie/encoder.hpp"
#include "store/run_file.hpp"

namespace hackle {
namespace {

// Returns "HDF5 1.10.8" without "HDF5 ".
std::string without(const std::string& name, const std::string& text) {
  return text.starts_with(name + " ") ? text.substr(name.size() + 1) : text;
}

}  // namespace

std::vector<Library> libraries() {
  return {
      {"Lua", fmt::format("{}.{}", LUA_VERSION_MAJOR "." LUA_VERSION_MINOR, LUA_VERSION_RELEASE)},
      {"HDF5", without("HDF5", RunFile::library_version())},
      {"FFmpeg", Encoder::library_version()},
      {"oneTBB", TBB_runtime_version()},
      {"Eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"Cairo", cairo_version_string()},
  };
}

std::string libraries_line() {
  std::string line;
  for (const Library& library : libraries())
    line += (line.empty() ? "" : ", ") + library.name + " " + library.version;
  return line;
}

}  // namespace hackle
