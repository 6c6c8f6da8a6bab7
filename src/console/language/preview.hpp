// SPDX-License-Identifier: MIT
// Pictures in a terminal, through chafa. The capabilities of the terminal are read from the
// environment and never requested from the terminal itself, so nothing can hang, not even over ssh.
#pragma once

#include <memory>
#include <string>

#include "base/image.hpp"
#include "output/picture/painting.hpp"

struct ChafaTermInfo;

namespace hackle {

// The form of a picture on the screen: text, or pixels in one of two protocols.
enum class Graphics { symbols, sixel, kitty };
// palette: 240 fixed colours; direct: 24 bit
enum class Colours { none, sixteen, palette, direct };

// The size of a terminal as the kernel reports it; pixels are 0 if unknown.
struct TerminalSize {
  int columns = 80, rows = 24;
  int width = 0, height = 0;  // px
};

struct Terminal {
  int columns = 80, rows = 24;
  Extent cell{8, 16};  // px per character, 1 to 2 if unknown
  Graphics graphics = Graphics::symbols;
  Colours colours = Colours::none;
  std::shared_ptr<ChafaTermInfo> sequences;  // its control sequences
};

// Determines the capabilities from `environment`, which like environ ends in a null pointer. With
// NO_COLOR, and for a terminal that is dumb or has no name, symbols without colour are used.
Terminal terminal_of(char** environment, const TerminalSize& size);

// Returns the terminal behind a file descriptor at its present size; 80 x 24 if it has none.
Terminal terminal_of(int file);

// Returns the pixels that a picture with texts may take: the width of the terminal, and its height
// minus the line of the call, the line below and the prompt.
Extent room_for_picture(const Terminal& terminal);

// Returns the pixels of a picture without texts, for a plate `shape` times as wide as high: it
// fills the width, or else the height, in whole characters, at least one. Symbols have 4 x 4 px
// whatever their shape on the screen.
Extent bare_picture(const Terminal& terminal, double shape);

// Returns the text to write to the terminal. With symbols the picture must consist of whole symbols
// of 4 x 4 px. Every line ends in a line feed. Throws Error (run_failed) if chafa draws nothing.
std::string text_of(const Image& picture, const Terminal& terminal);

// Writes the text to a file descriptor in parts: throws Error (interrupted) between two of them
// once interrupted(), and leaves the terminal in its usual state. Stops at a file that accepts no
// more.
void write_picture(const std::string& text, const Terminal& terminal, int file);

}  // namespace hackle
