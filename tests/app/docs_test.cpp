// SPDX-License-Identifier: MIT
// The reference that hackle docs writes.
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>

#include "app/man_page.hpp"
#include "app/program.hpp"
#include "app/shell_completion.hpp"
#include "app/voice.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "console/reference/vocabulary.hpp"
#include "support/skipping.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class DocsTest : public testing::Test {
 protected:
  std::string docs(std::vector<std::string> words) {
    words.insert(words.begin(), "docs");
    const auto ended = program_.run(words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    return ended.out;
  }

  test::Folder folder_;
  test::Program program_{folder_};
};

TEST_F(DocsTest, MarkdownHasEveryFunctionOptionAndField) {
  const std::string text = docs({});
  EXPECT_EQ(text, docs({"--markdown"}));
  for (const FunctionDoc* doc : all_docs()) {
    EXPECT_THAT(text, HasSubstr("### `" + call_name(*doc) + "`\n"));
    EXPECT_THAT(text, HasSubstr(std::string(doc->example)));
    for (const Option& option : doc->options)
      EXPECT_THAT(text, HasSubstr("\n| `" + std::string(option.name) + "` |"));
  }
  for (const TypeDoc* type : all_types())
    for (const Property& field : type->fields)
      EXPECT_THAT(text, HasSubstr("| `" + std::string(field.name) + "` |"));
  for (const char* part : {"hackle run [options] FILE", "| 130 |", "| `MPa` |", "| `duran50` |"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(DocsTest, TheManualPageHasEverySectionAndFunction) {
  const std::string text = docs({"--man"});
  EXPECT_THAT(text, StartsWith(".TH HACKLE 1"));
  for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS",
                              "SCENE LANGUAGE", "EXIT STATUS", "ENVIRONMENT"})
    EXPECT_THAT(text, HasSubstr(std::string("\n.SH ") + section + "\n"));
  for (const FunctionDoc* doc : all_docs()) EXPECT_THAT(text, HasSubstr("\\fB" + call_name(*doc)));
}

TEST_F(DocsTest, TheManualPageIsWellFormed) {
  write_text(folder_.path / "hackle.1", docs({"--man"}));
  const std::string page = shell_word((folder_.path / "hackle.1").string());
  HACKLE_NEEDS(std::system("command -v groff >/dev/null") == 0, "groff is not installed");
  EXPECT_EQ(std::system(("groff -man -ww -Tascii " + page + " 2>&1 >/dev/null | grep .").c_str()) &
                0xff00,
            0x100);
}

TEST_F(DocsTest, CompletionsKnowEveryCommandAndOption) {
  for (const std::string_view shell : shell_names) {
    const std::string text = docs({"--completion", std::string(shell)});
    for (const char* word :
         {"run", "bench", "info", "diff", "export", "docs", "instructions", "study", "lammps"})
      EXPECT_THAT(text, HasSubstr(word)) << shell;
  }
}

TEST_F(DocsTest, BashCompletes) {
  write_text(folder_.path / "completion", docs({"--completion", "bash"}));
  write_text(folder_.path / "scene.lua", "");
  const std::string before =
      "cd " + shell_word(folder_.path.string()) +
      "; . ./completion; offer() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($#-1)); "
      "_hackle; echo \"${COMPREPLY[*]}\"; }; offer hackle ";
  const auto offered = [&](const std::string& words) {
    const auto answer = folder_.path / "answer";
    const std::string command = "bash -c " + shell_word(before + words) + " > ";
    EXPECT_EQ(std::system((command + shell_word(answer.string())).c_str()), 0);
    return test::Program::text_of(answer);
  };
  EXPECT_EQ(offered("ru"), "run\n");
  EXPECT_EQ(offered("run sc"), "scene.lua\n");
  EXPECT_EQ(offered("run --js"), "--json\n");
  EXPECT_EQ(offered("info sc"), "scene.lua\n");
  EXPECT_EQ(offered("export --vtk"), "--vtk --vtkhdf\n");
  EXPECT_EQ(offered("bench --peer la"), "lammps\n");
  EXPECT_EQ(offered("docs --completion \"\""), "bash zsh fish\n");
}

TEST_F(DocsTest, EveryCommandHasHelpAndEveryOptionASentence) {
  for (const char* command : {"run", "bench", "info", "diff", "export", "docs"}) {
    const std::string help = program_.run({command, "-h"}).out;
    EXPECT_THAT(help, HasSubstr("Usage: hackle " + std::string(command)));
  }
  const std::string text = docs({});
  const std::string commands = text.substr(0, text.find("### Exit codes"));
  EXPECT_EQ(commands.find("|  |\n"), std::string::npos) << "an option without a sentence";
}

TEST_F(DocsTest, OneAtATime) {
  EXPECT_EQ(program_.run({"docs", "--man", "--markdown"}).code, 2);
  EXPECT_EQ(program_.run({"docs", "--completion", "csh"}).code, 2);
}

TEST(Voice, ErrorsAreRedBoldAndFaint) {
  const Error error(ErrorKind::refused, {{"a.lua:2: width is -1 m", "above 0 m"}, {"b", ""}});
  EXPECT_EQ(error_text(error, false), "error: a.lua:2: width is -1 m (above 0 m)\nerror: b\n");
  EXPECT_EQ(error_text(error, true),
            "\033[1;31merror:\033[0m \033[1ma.lua:2: width is -1 m\033[0m "
            "\033[2m(above 0 m)\033[0m\n\033[1;31merror:\033[0m \033[1mb\033[0m\n");
}

TEST(Voice, ErrorsFitTheTerminal) {
  const Error error(
      ErrorKind::refused,
      {{"crack.lua:12: crack: the crack from (0, 20 mm) to (50 mm, 20 mm) leaves the plate",
        "cracks lie within 40 mm x 10 mm, or end with ends = \"cut\" at its edges"}});
  for (std::size_t columns = 40; columns <= 200; ++columns) {
    std::istringstream lines(error_text(error, false, columns));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), columns) << line;
  }
  EXPECT_EQ(error_text(error, false, 400), error_text(error, false));
  EXPECT_THAT(error_text(error, false, 80),
              HasSubstr("leaves\n       the plate\n       (cracks lie"));
}

}  // namespace
}  // namespace hackle
