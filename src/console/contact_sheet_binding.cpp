// SPDX-License-Identifier: MIT
#include "console/contact_sheet_binding.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/files.hpp"
#include "console/arguments.hpp"
#include "console/guard.hpp"
#include "console/session.hpp"
#include "render/contact_sheet.hpp"
#include "render/png.hpp"

namespace hackle {
namespace {

constexpr std::array sheet_options{
    Option{.name = "file",
           .type = OptionType::text,
           .required = true,
           .positional = true,
           .sentence = "The sheet, a PNG, in the output folder if relative."},
    Option{.name = "pictures",
           .type = OptionType::texts,
           .range = at_least(1.0),
           .required = true,
           .sentence = "PNGs that exist already, in the output folder if relative."},
    Option{.name = "titles",
           .type = OptionType::texts,
           .range = at_least(1.0),
           .fallback = "the names of the files",
           .sentence = "What stands below each."},
    Option{.name = "columns",
           .type = OptionType::integer,
           .range = between(1.0, 64.0),
           .fallback = "4",
           .sentence = "Pictures side by side."},
    Option{.name = "width",
           .type = OptionType::integer,
           .unit = "px",
           .range = between(64.0, 4096.0),
           .fallback = "320",
           .sentence = "Of each picture; it gets 3/4 of that in height."},
};

constexpr FunctionDoc contact_sheet_doc{
    .name = "contact_sheet",
    .sentence = "Puts pictures that were written before on one, each with a title.",
    .options = sheet_options,
    .example =
        "-- contact_sheet { \"all.png\", pictures = { \"one.png\", \"two.png\" }, columns = "
        "2 }"};

// The files and what stands below them.
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

int make_contact_sheet(lua_State* L) {
  const Session& session = session_of(L);
  Arguments arguments = Arguments::from_table(L, 1, contact_sheet_doc);
  const std::vector<SheetPicture> pictures = pictures_of(session, arguments);
  arguments.problems.throw_if_any();
  SheetLayout layout;
  layout.columns = static_cast<int>(arguments.integer("columns", layout.columns));
  layout.width = static_cast<int>(arguments.integer("width", layout.width));
  const auto path = session.output_path("contact_sheet", arguments.text("file"));
  check_writable(path);
  if (session.settings.purpose != Purpose::results) return 0;
  const Image sheet = contact_sheet(pictures, layout);
  make_folder_of(path);
  write_png(sheet, path);
  return 0;
}

}  // namespace

std::span<const Function> contact_sheet_functions() {
  static constexpr std::array functions{Function{&contact_sheet_doc, guarded<make_contact_sheet>}};
  return functions;
}

}  // namespace hackle
