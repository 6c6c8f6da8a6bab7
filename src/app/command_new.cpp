// SPDX-License-Identifier: MIT
#include "app/command_new.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/streams.hpp"

namespace hackle {

int command_new(const std::string& name) {
  return exit_code_of([&] {
    std::filesystem::path path = name;
    if (path.extension() != ".lua") path += ".lua";
    if (std::filesystem::exists(path))
      throw Error(ErrorKind::files, fmt::format("'{}' is there already", path.string()),
                  "take another name");
    make_folder_of(path);
    write_text(path, read_text(data_file("assets/new.lua")));
    print_out("wrote {0}\nhackle check {0} estimates its cost, hackle run {0} runs it\n",
              path.string());
    return 0;
  });
}

}  // namespace hackle
