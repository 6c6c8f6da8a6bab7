// SPDX-License-Identifier: MIT
#include "output/files/fragments_file.hpp"

#include <iterator>
#include <string>

#include <fmt/format.h>

#include "base/files.hpp"

namespace hackle {

void write_fragments(const FragmentList& fragments, const std::filesystem::path& path) {
  std::string text =
      "number,nodes,area_m2,diameter_m,passing,mass_kg_per_m,x_m,y_m,vx_m_per_s,vy_m_per_s,"
      "spin_rad_per_s,kinetic_J_per_m\n";
  for (const MeasuredFragment& one : fragments.all)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{}\n", one.number,
                   one.nodes, one.area, one.diameter(), one.passing, one.mass, one.centre.x(),
                   one.centre.y(), one.velocity.x(), one.velocity.y(), one.spin, one.kinetic);
  make_folder_of(path);
  write_text(path, text);
}

}  // namespace hackle
