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
#include "output/replay.hpp"
#include "render/contact_sheet.hpp"

namespace hackle {
namespace {

constexpr int min_width = 320;  // px, of a painted picture

constexpr auto sheet_options = joined(
    std::array{
        Option{.name = "file",
               .type = OptionType::text,
               .required = true,
               .positional = true,
               .sentence = "File name of the sheet, a PNG; relative to the output folder."},
        Option{.name = "pictures",
               .type = OptionType::texts,
               .range = at_least(1.0),
               .alternative = true,
               .sentence = "Existing PNGs; relative to the output folder."},
        Option{.name = "recordings",
               .type = OptionType::recordings,
               .read = read_recordings,
               .range = at_least(1.0),
               .alternative = true,
               .sentence = "Or recordings, as returned by recording: one row per recording."},
        Option{.name = "times",
               .type = OptionType::numbers,
               .unit = "s",
               .range = at_least(1.0),
               .fallback = "the end",
               .sentence = "Times of recordings: one column per time; of one recording, in columns "
                           "like pictures."},
        Option{.name = "titles",
               .type = OptionType::texts,
               .range = at_least(1.0),
               .fallback = "the file names",
               .sentence = "Caption below each."},
        Option{.name = "columns",
               .type = OptionType::integer,
               .range = between(1.0, 64.0),
               .fallback = "4",
               .sentence = "Number of pictures per row."},
        Option{.name = "width",
               .type = OptionType::integer,
               .unit = "px",
               .range = between(64.0, 4096.0),
               .fallback = "320",
               .sentence =
                   "Width of each picture; its height is 3/4 of that, that of a record as needed."},
    },
    picture_options);

constexpr FunctionDoc contact_sheet_doc{
    .name = "contact_sheet",
    .sentence = "Puts existing pictures, or records of runs, on one sheet.",
    .options = sheet_options,
    .example =
        "-- contact_sheet { \"all.png\", pictures = { \"one.png\", \"two.png\" }, columns = "
        "2 }"};

// Returns the files with their captions.
std::vector<SheetPicture> pictures_of(const Session& session, Arguments& arguments) {
  const std::vector<std::string> titles = arguments.texts("titles");
  std::vector<SheetPicture> pictures;
  for (const std::string& name : arguments.texts("pictures"))
    pictures.push_back(
        {session.written_path("contact_sheet", name), std::filesystem::path(name).stem().string()});
  if (!arguments.has("titles") || pictures.empty()) return pictures;
  if (titles.size() != pictures.size())
    arguments.problems.add(fmt::format("contact_sheet: there are {} titles for {} pictures",
                                       titles.size(), pictures.size()),
                           "give as many, or none");
  for (std::size_t k = 0; k < std::min(titles.size(), pictures.size()); ++k)
    pictures[k].title = titles[k];
  return pictures;
}

// Existing pictures take no options of painting.
void check_kind(Arguments& arguments) {
  const bool recorded = arguments.has("recordings");
  if (arguments.good({"pictures", "recordings"}) && arguments.has("pictures") == recorded)
    arguments.problems.add(recorded ? "contact_sheet: pictures and recordings are given"
                                    : "contact_sheet: pictures is missing",
                           "a list of PNGs, or recordings = { ... }: one of the two");
  if (recorded || !arguments.has("pictures")) return;
  for (const Option& option : picture_options)
    if (arguments.has(option.name))
      arguments.problems.add(
          fmt::format("contact_sheet: {} cannot change pictures that exist", option.name),
          "it is for recordings");
  if (arguments.has("times"))
    arguments.problems.add("contact_sheet: times is given without recordings");
}

// Paints each picture at least as large as the smallest allowed.
Image sheet_of_recordings(const Arguments& arguments, const Tiles& tiles,
                          const SheetLayout& layout) {
  PictureOptions options = picture_of(arguments);
  options.width = std::max(min_width, layout.width + layout.width % 2);
  return sheet_of(tiles, arguments.numbers("times"), options, layout);
}

int make_contact_sheet(lua_State* L) {
  Session& session = session_of(L);
  Arguments arguments = Arguments::from_table(L, 1, contact_sheet_doc);
  check_kind(arguments);
  const bool recorded = arguments.has("recordings");
  const Tiles tiles = recorded ? tiles_of(arguments, "contact_sheet") : Tiles{};
  const auto pictures = recorded ? std::vector<SheetPicture>{} : pictures_of(session, arguments);
  arguments.problems.throw_if_any();
  SheetLayout layout;
  layout.columns = static_cast<int>(arguments.integer("columns", layout.columns));
  layout.width = static_cast<int>(arguments.integer("width", layout.width));
  session.write_picture("contact_sheet", arguments.text("file"), [&] {
    return recorded ? sheet_of_recordings(arguments, tiles, layout)
                    : contact_sheet(pictures, layout);
  });
  return 0;
}

}  // namespace

std::span<const Function> contact_sheet_functions() {
  static constexpr std::array functions{Function{&contact_sheet_doc, guarded<make_contact_sheet>}};
  return functions;
}

}  // namespace hackle
