// SPDX-License-Identifier: MIT
// What is said fits terminals of any width: no line is longer, and no word is broken.
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "terminal/terminal.hpp"

namespace hackle {
namespace {

class Width : public test::TerminalTest, public testing::WithParamInterface<int> {};

// What a newcomer sees: the tour, a plate, errors, a run with its progress, the report.
std::string transcript(int columns) {
  test::Terminal terminal(columns, 200);
  terminal.expect("leaves\n>");
  for (const char* line :
       {"help()", "help 'plate'", "p = plate { width = 100*mm, height = 40*mm }",
        "p = plate { width = 9, height = 4, material = 'glas' }", "p = plate { width = 1 }",
        "p=plate{width=9*mm,height=4*mm,material='duran50'}", "p:crck {}", "help 'csv'",
        "s=simulate(p,{spacing=.1*mm})", "s:run(3*us)", "s", "print(s:report())", "s.energy"})
    terminal.say(line);
  return terminal.shown();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.starts_with("> ")) lines.push_back(line);
  return lines;
}

std::size_t width_of(const std::string& line) {
  return static_cast<std::size_t>(std::ranges::count_if(
      line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Words without digits: numbers are those of the machine.
std::set<std::string> words_of(const std::vector<std::string>& lines) {
  std::set<std::string> words;
  for (const std::string& line : lines) {
    std::istringstream stream(line);
    for (std::string word; stream >> word;)
      if (std::ranges::none_of(word, [](unsigned char c) { return std::isdigit(c) != 0; }))
        words.insert(word);
  }
  return words;
}

TEST_P(Width, NoLineIsLongerAndNoWordIsBroken) {
  const std::vector<std::string> lines = lines_of(transcript(GetParam()));
  for (const std::string& line : lines)
    EXPECT_LE(width_of(line), static_cast<std::size_t>(GetParam())) << line;
  const std::set<std::string> wide = words_of(lines_of(transcript(240)));
  for (const std::string& word : words_of(lines)) EXPECT_TRUE(wide.contains(word)) << word;
}
INSTANTIATE_TEST_SUITE_P(OfTerminals, Width, testing::Values(40, 80, 120));

}  // namespace
}  // namespace hackle
