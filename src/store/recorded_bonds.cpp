// SPDX-License-Identifier: MIT
#include "store/recorded_bonds.hpp"

#include <vector>

namespace hackle {

void break_recorded(const Hdf5Reader& file, const std::string& group, const Lattice& lattice,
                    BondBits& bonds) {
  const Grid& grid = lattice.grid;
  const int words = lattice.family.words();
  const std::vector<std::uint32_t> broken =
      file.words(group + "/broken", {grid.nodes(), static_cast<hsize_t>(words)});
  auto bits = broken.begin();
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      for (int word = 0; word < words; ++word, ++bits)
        if (*bits != 0) bonds.clear(grid.layout().at(i, j), word, *bits);
}

}  // namespace hackle
