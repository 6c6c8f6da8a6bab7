// SPDX-License-Identifier: MIT
#include "console/language/contact_sheet_binding.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "console/language/picture_options.hpp"
#include "console/language/recording_binding.hpp"
#include "console/language/scripted_recording.hpp"
#include "console/lua/guard.hpp"
#include "console/schema/arguments.hpp"
#include "console/session.hpp"
#include "output/files/panels.hpp"
#include "output/files/replay.hpp"
#include "render/contact_sheet.hpp"
#include "render/png.hpp"
#include "render/vector_file.hpp"

namespace hackle {
namespace {

constexpr std::array runs_option{
    Option{.name = "recordings",
           .type = OptionType::recordings,
           .read = read_recordings,
           .range = at_least(1.0),
           .alternative = true,
           .sentence = "Or recordings, as returned by recording: one row per recording."}};

constexpr auto sheet_options = joined(
    joined(file_option, joined(options_of<SheetOptions>, runs_option)), unsized_picture_options);

constexpr FunctionDoc contact_sheet_doc{
    .name = "contact_sheet",
    .sentence = "Puts existing pictures, or records of runs, on one sheet.",
    .options = sheet_options,
    .example =
        "-- contact_sheet { \"all.png\", pictures = { \"one.png\", \"two.png\" }, columns = "
        "2 }"};

// Returns the files with their captions.
std::vector<SheetPicture> pictures_of(const Session& session, const SheetOptions& options,
                                      Problems& problems) {
  std::vector<SheetPicture> pictures;
  const std::vector<std::string> names =
      panel_names({options.pictures.begin(), options.pictures.end()});
  for (std::size_t k = 0; k < names.size(); ++k)
    pictures.push_back({session.written_path("contact_sheet", options.pictures[k]), names[k]});
  set_titles("contact_sheet", "pictures", options.titles, pictures, problems);
  return pictures;
}

// Existing pictures take no options of painting; the theme is that of the sheet, too.
void check_kind(Arguments& arguments) {
  const bool recorded = arguments.has("recordings");
  if (arguments.good({"pictures", "recordings"}) && arguments.has("pictures") == recorded)
    arguments.problems.add(recorded ? "contact_sheet: pictures and recordings are given"
                                    : "contact_sheet: pictures is missing",
                           "a list of PNGs, or recordings = { ... }: one of the two");
  if (recorded || !arguments.has("pictures")) return;
  for (const Option& option : unsized_picture_options)
    if (option.name != "theme" && arguments.has(option.name))
      arguments.problems.add(
          fmt::format("contact_sheet: {} cannot change pictures that exist", option.name),
          "it is for recordings");
  if (arguments.has("times"))
    arguments.problems.add("contact_sheet: times is given without recordings");
}

SheetLayout layout_of(const SheetOptions& options, Look look) {
  return {
      .columns = options.columns, .width = options.width, .look = look, .letters = options.letters};
}

// Paints each picture at least as large as the smallest allowed.
Image sheet_of_recordings(const Arguments& arguments, const Tiles& tiles,
                          const SheetOptions& sheet) {
  auto picture = noun_of<PictureOptions>(arguments);
  picture.width = std::max(min_picture_width, sheet.width + sheet.width % 2);
  return sheet_of(tiles, sheet.times, picture, layout_of(sheet, picture.look));
}

void refuse_vectors(const std::filesystem::path& path) {
  if (!is_vector_file(path)) return;
  throw Error(ErrorKind::refused,
              fmt::format("contact_sheet: '{}' would hold pixels only", path.filename().string()),
              "name a PNG; frame{} writes PDF and SVG");
}

int make_contact_sheet(lua_State* L) {
  Session& session = session_of(L);
  Arguments arguments = Arguments::from_table(L, 1, contact_sheet_doc);
  check_kind(arguments);
  const auto options = noun_of<SheetOptions>(arguments);
  const bool recorded = arguments.has("recordings");
  const Tiles tiles = recorded ? tiles_of(arguments, "contact_sheet") : Tiles{};
  const auto pictures =
      recorded ? std::vector<SheetPicture>{} : pictures_of(session, options, arguments.problems);
  arguments.problems.throw_if_any();
  refuse_vectors(arguments.text("file"));
  session.write_picture("contact_sheet", arguments.text("file"), [&](const auto& path) {
    const Image sheet =
        recorded
            ? sheet_of_recordings(arguments, tiles, options)
            : contact_sheet(pictures, layout_of(options, noun_of<PictureOptions>(arguments).look));
    write_png(sheet, path);
  });
  return 0;
}

}  // namespace

std::span<const Function> contact_sheet_functions() {
  static constexpr std::array functions{Function{&contact_sheet_doc, guarded<make_contact_sheet>}};
  return functions;
}

}  // namespace hackle
