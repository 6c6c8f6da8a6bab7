// SPDX-License-Identifier: MIT
#include "console/language/preview.hpp"

#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "render/colour_map.hpp"

namespace hackle {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Terminal terminal(std::vector<std::string> environment, const TerminalSize& size = {}) {
  std::vector<char*> pointers;
  for (std::string& variable : environment) pointers.push_back(variable.data());
  pointers.push_back(nullptr);
  return terminal_of(pointers.data(), size);
}

TEST(Preview, ReadsFromTheEnvironmentWhatATerminalCanDo) {
  struct Case {
    std::vector<std::string> environment;
    Graphics graphics;
    Colours colours;
  };
  for (const Case& c : {
           Case{{"TERM=xterm-256color"}, Graphics::symbols, Colours::palette},
           {{"TERM=xterm-256color", "COLORTERM=truecolor"}, Graphics::symbols, Colours::direct},
           {{"TERM=xterm-256color", "COLORTERM=24bit"}, Graphics::symbols, Colours::direct},
           {{"TERM=xterm-256color", "NO_COLOR="}, Graphics::symbols, Colours::palette},
           {{"TERM=xterm-256color", "NO_COLOR=1"}, Graphics::symbols, Colours::none},
           {{"TERM=linux"}, Graphics::symbols, Colours::sixteen},
           {{"TERM=dumb", "COLORTERM=truecolor"}, Graphics::symbols, Colours::none},
           {{}, Graphics::symbols, Colours::none},
           {{"TERM=xterm-kitty"}, Graphics::kitty, Colours::palette},
           {{"TERM=xterm-kitty", "NO_COLOR=1"}, Graphics::symbols, Colours::none},
           {{"TERM=mlterm"}, Graphics::sixel, Colours::palette},
           {{"TERM=xterm-256color", "TERM_PROGRAM=WezTerm"}, Graphics::sixel, Colours::palette},
           {{"TERM=xterm-256color", "TERM_PROGRAM=WezTerm", "TMUX=/tmp/t,1,0"},
            Graphics::symbols,
            Colours::palette},
           {{"TERM=screen-256color", "TERM_PROGRAM=WezTerm"}, Graphics::symbols, Colours::palette},
       }) {
    SCOPED_TRACE(testing::PrintToString(c.environment));
    const Terminal found = terminal(c.environment);
    EXPECT_EQ(found.graphics, c.graphics);
    EXPECT_EQ(found.colours, c.colours);
  }
}

TEST(Preview, TakesSizesThatCannotBeForUnknown) {
  for (const TerminalSize& size : {TerminalSize{80, 24},
                                   {80, 24, 80, 24},
                                   {80, 24, 8000, 100},
                                   {0, 0, 640, 480},
                                   {-5, -5, -5, -5}}) {
    const Terminal found = terminal({}, size);
    EXPECT_EQ(found.cell.width, 8);
    EXPECT_EQ(found.cell.height, 16);
    EXPECT_GE(found.columns, 1);
    EXPECT_GE(found.rows, 1);
  }
  EXPECT_EQ(terminal({}, {80, 24, 800, 480}).cell.width, 10);
  EXPECT_EQ(terminal({}, {80, 24, 800, 480}).cell.height, 20);
}

TEST(Preview, APictureFitsAndKeepsTheShapeOfThePlate) {
  for (const auto& [columns, rows] : {std::pair{80, 24}, {120, 35}, {200, 50}, {40, 10}, {20, 60}})
    for (const double shape : {2.5, 1.0, 0.4, 8.0}) {
      SCOPED_TRACE(testing::Message() << columns << " x " << rows << ", shape " << shape);
      const Terminal in = terminal({}, {columns, rows, 9 * columns, 18 * rows});
      const Extent picture = bare_picture(in, shape);
      const int wide = picture.width / 4, high = picture.height / 4;
      EXPECT_LE(wide, columns);
      EXPECT_LE(high, rows - 3);
      EXPECT_TRUE(wide == columns || high == rows - 3);
      EXPECT_NEAR(wide / shape, 2.0 * high, 1.5 + 1.0 / shape);  // whole characters
    }
}

TEST(Preview, ThereIsAlwaysRoomForACharacter) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 3}, {3, 1}, {5, 4}})
    for (const double shape : {1e-4, 1.0, 1e4}) {
      const Extent picture = bare_picture(terminal({}, {columns, rows}), shape);
      EXPECT_GE(picture.width, 4);
      EXPECT_GE(picture.height, 4);
      EXPECT_LE(picture.width, 4 * columns);
    }
}

TEST(Preview, LargePicturesStayBounded) {
  const Extent room = room_for_picture(terminal({"TERM=mlterm"}, {400, 100, 4000, 2000}));
  EXPECT_EQ(room.width, 1600);
  EXPECT_EQ(room.height, 97 * 20);
}

// Makes 320 x 64 px for 80 x 16 symbols: a plate, with or without a crack one px high.
Image plate_picture(bool cracked) {
  Image image(320, 64);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const bool bright = cracked && y == 33 && x < 160;
      const Colour c = bright ? Colour{255, 246, 219} : Colour{36, 54, 79};
      auto* at = &image.pixels[static_cast<std::size_t>(y * image.stride() + 4 * x)];
      at[0] = c.blue, at[1] = c.green, at[2] = c.red, at[3] = 0;
    }
  return image;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class Symbols : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Symbols, ACrackChangesItsOwnLineOnly) {
  const Terminal in = terminal(GetParam());
  const auto intact = lines_of(text_of(plate_picture(false), in));
  const auto cracked = lines_of(text_of(plate_picture(true), in));
  ASSERT_EQ(intact.size(), 16U);
  ASSERT_EQ(cracked.size(), 16U);
  for (std::size_t line = 0; line < 16; ++line)
    EXPECT_EQ(line == 8, intact[line] != cracked[line]) << line;
}

TEST_P(Symbols, PaintTheSameTwice) {
  const Terminal in = terminal(GetParam());
  EXPECT_EQ(text_of(plate_picture(true), in), text_of(plate_picture(true), in));
}

INSTANTIATE_TEST_SUITE_P(Colours, Symbols,
                         testing::Values(std::vector<std::string>{"TERM=xterm-256color",
                                                                  "COLORTERM=truecolor"},
                                         std::vector<std::string>{"TERM=xterm-256color"},
                                         std::vector<std::string>{"TERM=linux"},
                                         std::vector<std::string>{"TERM=xterm", "NO_COLOR=1"}));

TEST(Preview, WithoutColourNothingButCharactersIsWritten) {
  const std::string text = text_of(plate_picture(true), terminal({"TERM=dumb"}));
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  const std::string blank(80, ' ');
  for (const std::size_t line : {0, 7, 9, 15}) EXPECT_EQ(lines_of(text)[line], blank) << line;
  EXPECT_THAT(lines_of(text)[8], testing::EndsWith(std::string(40, ' ')));
  EXPECT_THAT(lines_of(text)[8], Not(StartsWith(" ")));
}

TEST(Preview, WritesPixelsInTheLanguageOfTheTerminal) {
  const std::string sixel = text_of(plate_picture(true), terminal({"TERM=mlterm"}));
  EXPECT_THAT(sixel, HasSubstr("\033P"));
  EXPECT_THAT(sixel, testing::EndsWith("\033\\\n"));
  const std::string kitty = text_of(plate_picture(true), terminal({"TERM=xterm-kitty"}));
  EXPECT_THAT(kitty, HasSubstr("\033_G"));
  EXPECT_THAT(kitty, testing::EndsWith("\n"));
}

TEST(Preview, PixelsNeedNotBeWholeCharacters) {
  for (const char* name : {"TERM=mlterm", "TERM=xterm-kitty"})
    EXPECT_GT(text_of(Image(321, 77), terminal({name}, {80, 24, 720, 408})).size(), 100U);
}

// Captures the text that arrives at the other end of a pipe.
class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe(ends_), 0); }
  ~Pipe() {
    close(ends_[0]);
    close(ends_[1]);
  }
  int entry() const { return ends_[1]; }
  std::string drain() const {
    std::string text(65536, '\0');
    text.resize(static_cast<std::size_t>(read(ends_[0], text.data(), text.size())));
    return text;
  }

 private:
  int ends_[2] = {-1, -1};
};

TEST(Preview, ArrivesWhole) {
  const Pipe pipe;
  const std::string text(20000, 'x');
  write_picture(text, terminal({}), pipe.entry());
  EXPECT_EQ(pipe.drain(), text);
}

TEST(Preview, AnInterruptLeavesTheTerminalAsItWas) {
  for (const auto& [name, ending] :
       {std::pair{"TERM=xterm", "\033[0m\n"}, {"TERM=dumb", "\n"}, {"TERM=mlterm", "\033\\\n"}}) {
    const Pipe pipe;
    request_interrupt();
    try {
      write_picture("picture", terminal({name}), pipe.entry());
      ADD_FAILURE() << "not interrupted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    }
    clear_interrupt();
    EXPECT_EQ(pipe.drain(), ending);
  }
}

}  // namespace
}  // namespace hackle
