// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "console/scripts.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(ContactSheetBinding, PutsFramesOnASheet) {
  const test::Folder folder;
  EXPECT_EQ(test::message_of(test::scene + R"(
    s:frame { "one.png", width = 320 }
    contact_sheet { "sub/all.png", pictures = { "one.png", "one.png" } }
    contact_sheet { "titled.png", pictures = { "one.png" }, titles = { "The first" }, columns = 1, width = 64 }
  )",
                             test::quiet(folder.path)),
            "");
  EXPECT_TRUE(fs::is_regular_file(folder.path / "sub" / "all.png"));
  EXPECT_TRUE(fs::is_regular_file(folder.path / "titled.png"));
}

TEST(ContactSheetBinding, RefusesBadInput) {
  struct Bad {
    const char* options;
    const char* message;
  };
  for (const Bad& bad : {
           Bad{"'all.png'", "pictures is missing"},
           {"{ pictures = { 'a.png' } }", "file is missing"},
           {"{ 'all.png', pictures = 'a.png' }", "pictures is the text 'a.png'"},
           {"{ 'all.png', pictures = {} }", "a list of 1 or more texts"},
           {"{ 'all.png', pictures = { 'a.png', x = 1 } }", "a list of 1 or more texts"},
           {"{ 'all.png', pictures = { 'a.png', 3 } }", "entry 2 of pictures is no text"},
           {"{ 'all.png', pictures = { '' } }", "entry 1 of pictures is no text"},
           {"{ 'all.png', pictures = { 'a\\0b' } }", "entry 1 of pictures is no text"},
           {"{ 'all.png', pictures = { 'a.png' }, titles = { 'a', 'b' } }",
            "2 titles for 1 pictures"},
           {"{ 'all.png', pictures = { 'a.png' }, columns = 0 }", "columns is 0"},
           {"{ 'all.png', pictures = { 'a.png' }, columns = 2.5 }", "columns is 2.5"},
           {"{ 'all.png', pictures = { 'a.png' }, width = 0/0 }", "width is"},
           {"{ 'all.png', pictures = { 'a.png' }, rows = 2 }", "unknown option 'rows'"},
           {"{ 'all.png', pictures = { 'nowhere.png' } }", "cannot read the picture"},
           {"7", "expected options in braces"},
       }) {
    const test::Folder folder;
    EXPECT_THAT(test::message_of(std::string("contact_sheet(") + bad.options + ")",
                                 test::quiet(folder.path)),
                HasSubstr(bad.message))
        << bad.options;
    EXPECT_TRUE(fs::is_empty(folder.path)) << bad.options;
  }
}

}  // namespace
}  // namespace hackle
