// SPDX-License-Identifier: MIT
// Citations in comments must exist in the project: a Markdown file, named from the top of the
// checkout, and an item of it by number or heading, as in src/solver/README.md 4.2 or README.md,
// "--json".
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/files.hpp"
#include "support/folder.hpp"

namespace hackle {
namespace fs = std::filesystem;
namespace {

struct Citation {
  std::string file;
  std::vector<std::string> items;  // "4.2", or the text of a heading; empty: the whole file
  std::size_t at = 0;              // in the text
};

std::vector<Citation> citations_in(const std::string& text) {
  static const std::regex pattern(
      R"re(([\w./-]+\.md)\b(?:,? "([^"]+)"|,? (\d+(?:\.\d+)?(?:(?:, | and | to )\d+\.\d+)*)(?!\w))?)re");
  static const std::regex number(R"(\d+(\.\d+)?)");
  std::vector<Citation> list;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    list.push_back({(*match)[1], {}, static_cast<std::size_t>(match->position())});
    if ((*match)[2].matched) list.back().items.push_back((*match)[2]);
    const std::string numbers = (*match)[3];
    for (std::sregex_iterator item(numbers.begin(), numbers.end(), number); item != end; ++item)
      list.back().items.push_back(item->str());
  }
  return list;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  }
  return lines;
}

// Returns the items of a document that can be cited: headings without code marks, their numbers,
// and numbers at the beginning of a paragraph in bold face.
std::set<std::string> items_of(const std::string& document) {
  static const std::regex heading(R"(^#+ +((\d+(?:\.\d+)?)?.*))"),
      paragraph(R"(^\*\*(\d+\.\d+) .*)");
  std::set<std::string> items;
  for (std::string line : lines_of(document)) {
    std::erase(line, '`');
    std::smatch match;
    if (std::regex_match(line, match, heading))
      items.insert({match[1], match[2]});
    else if (std::regex_match(line, match, paragraph))
      items.insert(match[1]);
  }
  return items;
}

// Returns the comment mark of a file's language; empty for a language without comments.
std::string_view mark_of_comments(const fs::path& file) {
  static const std::map<std::string, std::string_view> marks{
      {".cpp", "//"}, {".hpp", "//"}, {".frag", "//"}, {".vert", "//"},
      {".lua", "--"}, {".sh", "#"},   {".cmake", "#"}};
  if (file.filename() == "CMakeLists.txt") return "#";
  const auto found = marks.find(file.extension().string());
  return found == marks.end() ? std::string_view() : found->second;
}

// Returns the text after the mark, unless the mark is in quotation marks.
std::string_view comment_of(std::string_view line, std::string_view mark) {
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (quoted && line[k] == '\\')
      ++k;
    else if (line[k] == '"' && (k == 0 || line[k - 1] != '\''))
      quoted = !quoted;
    else if (!quoted && line.substr(k).starts_with(mark))
      return line.substr(k + mark.size());
  }
  return {};
}

// Comments of consecutive lines as one text, because a citation may continue on the next line.
struct CommentBlock {
  std::string text;
  std::vector<std::size_t> begins;  // of each line, in the text
  std::size_t first_line = 1;

  std::size_t line_at(std::size_t place) const {
    return first_line - 1 +
           static_cast<std::size_t>(std::ranges::upper_bound(begins, place) - begins.begin());
  }
};

std::vector<CommentBlock> comments_in(const std::string& source, std::string_view mark) {
  std::vector<CommentBlock> blocks;
  std::size_t line = 0;
  bool goes_on = false;
  for (const std::string& text : lines_of(source)) {
    ++line;
    const std::string_view comment = comment_of(text, mark);
    if (!comment.empty()) {
      if (!goes_on) blocks.push_back({{}, {}, line});
      blocks.back().begins.push_back(blocks.back().text.size());
      blocks.back().text += comment;
    }
    goes_on = !comment.empty();
  }
  return blocks;
}

// Collects the citations of a checkout, and those that lead nowhere: "src/a.cpp:3: ...".
class Survey {
 public:
  explicit Survey(const fs::path& top) : top_(top) {
    for (const char* folder : {"src", "tests", "scripts", "shaders"}) {
      if (!fs::exists(top / folder)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(top / folder))
        if (entry.is_regular_file()) visit(entry.path());
    }
    std::ranges::sort(dangling);
  }

  int seen = 0;
  std::vector<std::string> dangling;

 private:
  void visit(const fs::path& file) {
    const std::string_view mark = mark_of_comments(file);
    if (mark.empty()) return;
    for (const CommentBlock& block : comments_in(read_text(file), mark))
      for (const Citation& citation : citations_in(block.text)) {
        ++seen;
        for (const std::string& fault : faults_of(citation))
          dangling.push_back(fs::relative(file, top_).string() + ":" +
                             std::to_string(block.line_at(citation.at)) + ": " + fault);
      }
  }

  std::vector<std::string> faults_of(const Citation& citation) {
    const auto& items = items_in(citation.file);
    if (!items) return {"there is no " + citation.file};
    std::vector<std::string> faults;
    for (const std::string& item : citation.items)
      if (!items->contains(item)) faults.push_back(citation.file + " has no item " + item);
    return faults;
  }

  const std::optional<std::set<std::string>>& items_in(const std::string& file) {
    const auto [known, is_new] = documents_.try_emplace(file);
    if (is_new && fs::exists(top_ / file)) known->second = items_of(read_text(top_ / file));
    return known->second;
  }

  fs::path top_;
  std::map<std::string, std::optional<std::set<std::string>>> documents_;
};

void write_file(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

TEST(Citations, OfCommentsLeadSomewhere) {
  const Survey survey{fs::path(HACKLE_SOURCE_FOLDER)};
  for (const std::string& fault : survey.dangling) ADD_FAILURE() << fault;
  EXPECT_GT(survey.seen, 30);
}

TEST(Citations, ThatLeadNowhereAreFoundByFileAndLine) {
  const test::Folder folder;
  write_file(folder.path / "src/room/README.md",
             "# Room\n\n## 1. One\n\n**1.1 First.** Text.\n\n### `--json`\n");
  write_file(folder.path / "src/room/right.cpp",
             "// src/room/README.md; src/room/README.md 1: 2e-7, src/room/README.md 1.1.\n"
             "int a;  // (src/room/README.md, \"--json\")\n"
             "const char* text = \"// no/such.md\";\n");
  write_file(folder.path / "src/room/wrong.cpp",
             "// See src/room/README.md\n// 1.2, which is not there.\nint a;\n\n"
             "int b;  // physics.md 4.1\nint c;  // src/room/README.md 1.1 and 2.3\n"
             "int d;  // src/room/README.md \"--jason\"\n");
  write_file(folder.path / "scripts/a.lua", "local x = 1  -- src/room/README.md 1.1 to 1.4\n");
  write_file(folder.path / "shaders/a.frag", "// README.md\n");
  const Survey survey(folder.path);
  EXPECT_EQ(survey.seen, 10);
  EXPECT_EQ(survey.dangling, (std::vector<std::string>{
                                 "scripts/a.lua:1: src/room/README.md has no item 1.4",
                                 "shaders/a.frag:1: there is no README.md",
                                 "src/room/wrong.cpp:1: src/room/README.md has no item 1.2",
                                 "src/room/wrong.cpp:5: there is no physics.md",
                                 "src/room/wrong.cpp:6: src/room/README.md has no item 2.3",
                                 "src/room/wrong.cpp:7: src/room/README.md has no item --jason"}));
}

// Links of documents, "[text](file)", relative to the document.
TEST(Citations, LinksOfDocumentsLeadToFiles) {
  const fs::path top = HACKLE_SOURCE_FOLDER;
  const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  int seen = 0;
  for (const char* document :
       {"README.md", "CONTRIBUTING.md", "src/README.md", "src/lattice/README.md",
        "src/measure/README.md", "src/solver/README.md", "src/study/README.md", "tests/README.md",
        "scripts/README.md"}) {
    const std::string text = read_text(top / document);
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      ++seen;
      const fs::path target = (top / document).parent_path() / (*match)[1].str();
      EXPECT_TRUE(fs::exists(target)) << document << ": " << (*match)[1];
    }
  }
  EXPECT_GT(seen, 30);
}

}  // namespace
}  // namespace hackle
