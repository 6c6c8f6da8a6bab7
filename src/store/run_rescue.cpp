// SPDX-License-Identifier: MIT
#include "store/run_rescue.hpp"

#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/partial_file.hpp"
#include "store/hdf5_reader.hpp"
#include "store/inputs_reader.hpp"
#include "store/run_file.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// The facts about a run file that a sidecar needs.
struct Contents {
  Grid grid;
  std::vector<double> times;
  bool has_material = false;
  std::vector<SidecarField> fields;
};

// Returns nothing for a file that we did not write, or that is complete or empty.
std::optional<Contents> cut_off_contents(const fs::path& path) {
  try {
    const Hdf5Reader file(path);
    if (!file.has_attribute("complete") || file.integer("complete") != 0 ||
        file.attribute("software") != "Hackle" ||
        file.integer("format_version") < oldest_run_file_format ||
        file.integer("format_version") > run_file_format)
      return std::nullopt;
    const std::int64_t records = file.integer("records_committed");
    if (records < 1) return std::nullopt;
    const Inputs inputs = read_inputs(file.text("inputs"));
    const Grid grid = make_grid(inputs.plate, inputs.numerics.spacing);
    const RecordContents contents = contents_of(file, grid);
    return Contents{grid_of(contents.nodes, grid),
                    file.first_doubles("time", static_cast<hsize_t>(records)),
                    file.holds("material"), sidecar_fields(contents)};
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;
    return std::nullopt;
  }
}

fs::path free_name(const fs::path& path, const std::function<bool(const fs::path&)>& taken) {
  return cut_off_name(path, [&](const fs::path& name) {
    std::error_code ignored;
    const fs::path sidecar = sidecar_of(name);
    return taken(name) || taken(sidecar) || fs::exists(fs::symlink_status(sidecar, ignored));
  });
}

}  // namespace

std::optional<RescuedRun> rescue_run(const fs::path& path,
                                     const std::function<bool(const fs::path&)>& taken) {
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) return std::nullopt;
  const std::optional<Contents> contents = cut_off_contents(path);
  if (!contents) return std::nullopt;
  const fs::path name = free_name(path, taken);
  fs::rename(path, name, failure);
  if (failure)
    throw Error(ErrorKind::files,
                "cannot keep '" + path.string() + "', which was cut off: " + failure.message(),
                "move it away, or choose another file name");
  write_text(sidecar_of(name),
             xdmf(contents->grid, name, contents->times, contents->has_material, contents->fields));
  return RescuedRun{name, static_cast<std::int64_t>(contents->times.size())};
}

}  // namespace hackle
