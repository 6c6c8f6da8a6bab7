// SPDX-License-Identifier: MIT
// The location of the checkout must not matter to a build.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/files.hpp"
#include "base/text.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

// Returns the name that scripts/plain_name.sh gives to a checkout with that name.
fs::path plain_name_of(const fs::path& folder, const char* name) {
  fs::create_directories(folder / name / "scripts");
  const fs::path script = folder / name / "scripts/plain_name.sh";
  fs::copy_file(fs::path(HACKLE_SOURCE_FOLDER) / "scripts/plain_name.sh", script);
  const fs::path answer = folder / "answer";
  const std::string command = "XDG_CACHE_HOME=" + shell_word((folder / "cache").string()) + " " +
                              shell_word(script.string()) + " > " + shell_word(answer.string());
  EXPECT_EQ(std::system(command.c_str()), 0);
  const std::string said = read_text(answer);
  return said.substr(0, said.find('\n'));
}

TEST(PlainName, IsItsOwnWhereBuildersCanTakeThat) {
  const test::Folder folder;
  for (const char* name : {"hackle", "a b/x_1+2"})
    EXPECT_EQ(plain_name_of(folder.path, name), folder.path / name);
}

TEST(PlainName, IsALinkWhereTheyCannotAndStaysTheSame) {
  const test::Folder folder;
  for (const char* name : {"it's", "a \"pläte\"", "50% $HOME;x", "[a](b)&c#d"}) {
    const fs::path plain = plain_name_of(folder.path, name);
    EXPECT_EQ(plain.parent_path(), folder.path / "cache/hackle");
    EXPECT_EQ(fs::canonical(plain), fs::canonical(folder.path / name));
    fs::remove_all(folder.path / name);
    EXPECT_EQ(plain_name_of(folder.path, name), plain);
  }
}

}  // namespace
}  // namespace hackle
