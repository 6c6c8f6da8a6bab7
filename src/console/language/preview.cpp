// SPDX-License-Identifier: MIT
#include "console/language/preview.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <string_view>
#include <vector>

#include <chafa.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "render/theme.hpp"

namespace hackle {
namespace {

constexpr int symbol_size = 4;   // px per side: a crack finer than a quarter of a symbol fades
constexpr int lines_kept = 3;    // for the call, the line below, the prompt
constexpr int max_width = 1600;  // px: larger pictures take seconds over a slow line
constexpr std::size_t piece_size = 4096;  // bytes between two checks for Ctrl-C

struct Release {
  void operator()(ChafaSymbolMap* map) const { chafa_symbol_map_unref(map); }
  void operator()(ChafaCanvasConfig* config) const { chafa_canvas_config_unref(config); }
  void operator()(ChafaCanvas* canvas) const { chafa_canvas_unref(canvas); }
  void operator()(GString* text) const { g_string_free(text, TRUE); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

std::string_view variable(char** environment, const char* name) {
  const char* value = g_environ_getenv(environment, name);
  return value != nullptr ? value : "";
}

bool knows(const Terminal& terminal, ChafaTermSeq sequence) {
  return chafa_term_info_have_seq(terminal.sequences.get(), sequence) != FALSE;
}

Colours colours_of(const Terminal& terminal, char** environment) {
  const std::string_view term = variable(environment, "TERM");
  if (!variable(environment, "NO_COLOR").empty() || term.empty() || term == "dumb")
    return Colours::none;
  const std::string_view promise = variable(environment, "COLORTERM");
  if ((promise == "truecolor" || promise == "24bit") &&
      knows(terminal, CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT))
    return Colours::direct;
  if (knows(terminal, CHAFA_TERM_SEQ_SET_COLOR_FGBG_256)) return Colours::palette;
  return Colours::sixteen;
}

// Inside a multiplexer the variables still describe the terminal outside, but pictures do not get
// through to it.
bool is_multiplexed(char** environment) {
  const std::string_view term = variable(environment, "TERM");
  return term.starts_with("screen") || term.starts_with("tmux") ||
         !variable(environment, "TMUX").empty() || !variable(environment, "STY").empty();
}

Graphics graphics_of(const Terminal& terminal, char** environment) {
  if (terminal.colours == Colours::none || is_multiplexed(environment)) return Graphics::symbols;
  if (knows(terminal, CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1)) return Graphics::kitty;
  if (knows(terminal, CHAFA_TERM_SEQ_BEGIN_SIXELS)) return Graphics::sixel;
  return Graphics::symbols;
}

// Some terminals report impossible sizes.
Extent cell_of(const TerminalSize& size, Extent usual) {
  const Extent cell{size.width / std::max(size.columns, 1), size.height / std::max(size.rows, 1)};
  const bool likely = cell.width >= 4 && cell.width <= 64 && cell.height >= cell.width &&
                      cell.height <= 4 * cell.width;
  return likely ? cell : usual;
}

int rows_for_picture(const Terminal& terminal) {
  return std::max(1, terminal.rows - lines_kept);
}

Extent cell_size(const Terminal& terminal) {
  if (terminal.graphics == Graphics::symbols) return {symbol_size, symbol_size};
  return terminal.cell;
}

int quotient_above(int dividend, int divisor) {
  return (dividend + divisor - 1) / divisor;
}

// Removes alpha and adds background at the right and below; row by row, blue, green, red.
std::vector<guint8> padded(const Image& picture, int width, int height) {
  const Colour ground = background_colour;
  std::vector<guint8> pixels;
  const std::uint8_t* from = picture.pixels.data();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (x < picture.width && y < picture.height) {
        pixels.insert(pixels.end(), from, from + 3);
        from += 4;
      } else {
        pixels.insert(pixels.end(), {ground.blue, ground.green, ground.red});
      }
    }
  return pixels;
}

ChafaCanvasMode canvas_mode(Colours colours) {
  switch (colours) {
    case Colours::none:
      return CHAFA_CANVAS_MODE_FGBG;
    case Colours::sixteen:
      return CHAFA_CANVAS_MODE_INDEXED_16;
    case Colours::palette:
      return CHAFA_CANVAS_MODE_INDEXED_240;
    case Colours::direct:
      break;
  }
  return CHAFA_CANVAS_MODE_TRUECOLOR;
}

ChafaPixelMode pixel_mode(Graphics graphics) {
  switch (graphics) {
    case Graphics::sixel:
      return CHAFA_PIXEL_MODE_SIXELS;
    case Graphics::kitty:
      return CHAFA_PIXEL_MODE_KITTY;
    case Graphics::symbols:
      break;
  }
  return CHAFA_PIXEL_MODE_SYMBOLS;
}

// Blocks fill their cells in every font; lines and wedges do not, or are missing.
Owned<ChafaSymbolMap> symbols() {
  Owned<ChafaSymbolMap> map(chafa_symbol_map_new());
  chafa_symbol_map_add_by_tags(map.get(), CHAFA_SYMBOL_TAG_SPACE);
  chafa_symbol_map_add_by_tags(map.get(), CHAFA_SYMBOL_TAG_BLOCK);
  return map;
}

Owned<ChafaCanvas> canvas_for(const Terminal& terminal, int columns, int rows) {
  const Owned<ChafaCanvasConfig> config(chafa_canvas_config_new());
  const Extent cell = cell_size(terminal);
  // The mean of bright and dark pixels would be a colour that is not in the colour map.
  chafa_canvas_config_set_color_extractor(config.get(), CHAFA_COLOR_EXTRACTOR_MEDIAN);
  chafa_canvas_config_set_geometry(config.get(), columns, rows);
  chafa_canvas_config_set_cell_geometry(config.get(), cell.width, cell.height);
  chafa_canvas_config_set_canvas_mode(config.get(), terminal.graphics == Graphics::symbols
                                                        ? canvas_mode(terminal.colours)
                                                        : CHAFA_CANVAS_MODE_TRUECOLOR);
  chafa_canvas_config_set_pixel_mode(config.get(), pixel_mode(terminal.graphics));
  chafa_canvas_config_set_symbol_map(config.get(), symbols().get());
  // Preprocessing would stretch the contrast of every picture separately.
  chafa_canvas_config_set_preprocessing_enabled(config.get(), FALSE);
  return Owned<ChafaCanvas>(chafa_canvas_new(config.get()));
}

// Returns the sequence that ends a picture cut off in the middle.
std::string_view ending(const Terminal& terminal) {
  if (terminal.graphics != Graphics::symbols) return "\033\\\n";
  return terminal.colours == Colours::none ? "\n" : "\033[0m\n";
}

// Returns false if the file accepts no more.
bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Terminal terminal_of(char** environment, const TerminalSize& size) {
  Terminal terminal;
  terminal.columns = std::clamp(size.columns, 1, 1000);
  terminal.rows = std::clamp(size.rows, 1, 500);
  terminal.cell = cell_of(size, terminal.cell);
  terminal.sequences.reset(chafa_term_db_detect(chafa_term_db_get_default(), environment),
                           chafa_term_info_unref);
  terminal.colours = colours_of(terminal, environment);
  terminal.graphics = graphics_of(terminal, environment);
  return terminal;
}

Terminal terminal_of(int file) {
  winsize size{};
  if (ioctl(file, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
    return terminal_of(environ, TerminalSize{});
  return terminal_of(environ, {size.ws_col, size.ws_row, size.ws_xpixel, size.ws_ypixel});
}

Extent room_for_picture(const Terminal& terminal) {
  return {std::min(terminal.columns * terminal.cell.width, max_width),
          rows_for_picture(terminal) * terminal.cell.height};
}

Extent bare_picture(const Terminal& terminal, double shape) {
  const double rows_a_column = terminal.cell.width / (shape * terminal.cell.height);
  const int max_rows = rows_for_picture(terminal);
  const double wide = std::min<double>(terminal.columns, max_rows / rows_a_column);
  const int columns = std::max(1, static_cast<int>(wide));
  const int rows = std::clamp(static_cast<int>(std::lround(wide * rows_a_column)), 1, max_rows);
  const Extent cell = cell_size(terminal);
  return {columns * cell.width, rows * cell.height};
}

std::string text_of(const Image& picture, const Terminal& terminal) {
  const Extent cell = cell_size(terminal);
  const int columns = quotient_above(picture.width, cell.width);
  const int rows = quotient_above(picture.height, cell.height);
  const int width = columns * cell.width, height = rows * cell.height;
  const Owned<ChafaCanvas> canvas = canvas_for(terminal, columns, rows);
  chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_BGR8,
                               padded(picture, width, height).data(), width, height, 3 * width);
  const Owned<GString> text(chafa_canvas_print(canvas.get(), terminal.sequences.get()));
  if (!text) throw Error(ErrorKind::run_failed, "chafa does not draw the picture");
  return std::string(text->str, text->len) + "\n";
}

void write_picture(const std::string& text, const Terminal& terminal, int file) {
  std::string_view rest = text;
  while (!rest.empty() && !interrupted()) {
    if (!write_all(file, rest.substr(0, piece_size))) return;
    rest.remove_prefix(std::min(piece_size, rest.size()));
  }
  if (rest.empty()) return;
  write_all(file, ending(terminal));
  throw Error(ErrorKind::interrupted, "interrupted");
}

}  // namespace hackle
