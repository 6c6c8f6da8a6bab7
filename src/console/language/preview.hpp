// SPDX-License-Identifier: MIT
// Pictures in a terminal, through chafa. What the terminal can do is read from the environment and
// never asked of the terminal itself: nothing can hang, over ssh neither.
#pragma once

#include <memory>
#include <string>

#include "base/image.hpp"
#include "output/painting.hpp"

struct ChafaTermInfo;

namespace hackle {

// How a picture reaches the screen: as text, or as pixels in one of two protocols.
enum class Graphics { symbols, sixel, kitty };
enum class Colours { none, sixteen, palette, direct };  // palette: 240 fixed ones; direct: 24 bit

// What the kernel knows of a terminal; pixels are 0 where the terminal does not tell.
struct TerminalSize {
  int columns = 80, rows = 24;
  int width = 0, height = 0;  // px
};

struct Terminal {
  int columns = 80, rows = 24;
  Extent cell{8, 16};  // px of a character, 1 to 2 where it is not known
  Graphics graphics = Graphics::symbols;
  Colours colours = Colours::none;
  std::shared_ptr<ChafaTermInfo> sequences;  // its language
};

// `environment` as environ, ending in a null pointer. NO_COLOR, and a terminal that is dumb or has
// no name, mean symbols without colour.
Terminal terminal_of(char** environment, const TerminalSize& size);

// The terminal behind a file descriptor, as large as it is now; 80 x 24 if it has no size.
Terminal terminal_of(int file);

// The pixels that a picture with texts may take: the width of the terminal, and its height less the
// line of the call, the line beneath and the prompt.
Extent room_for_picture(const Terminal& terminal);

// The pixels of a picture without texts, for a plate `shape` times as wide as it is high: it fills
// the width, or else the height, in whole characters, at least one. Symbols have 4 x 4 px whatever
// their shape on the screen.
Extent bare_picture(const Terminal& terminal, double shape);

// What to write to the terminal. With symbols the picture must consist of whole ones, of 4 x 4 px.
// Every line ends in a line feed. Throws Error (run_failed) when chafa draws nothing.
std::string text_of(const Image& picture, const Terminal& terminal);

// Writes the text to a file descriptor, in pieces: throws Error (interrupted) between two of them
// once interrupted(), and leaves the terminal in its usual state. A file that takes no more is
// left.
void write_picture(const std::string& text, const Terminal& terminal, int file);

}  // namespace hackle
