// SPDX-License-Identifier: MIT
#include "study/envelope_map.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "base/text.hpp"
#include "render/overlay/canvas.hpp"
#include "render/overlay/font.hpp"

namespace hackle {
namespace {

constexpr std::array ends{CellEnd::right, CellEnd::refused, CellEnd::stopped, CellEnd::failed};
constexpr std::array<char, 4> letters{'+', 'r', 's', 'X'};
// Distinguishable for colour-blind people, and by brightness.
constexpr std::array<Colour, 4> colours{
    {{0x1b, 0x9e, 0x77}, {0x9d, 0xb4, 0xd6}, {0xe6, 0xab, 0x02}, {0xc2, 0x18, 0x2b}}};
constexpr Colour ink{0x22, 0x26, 0x2e}, faint_ink{0x6b, 0x72, 0x80}, paper_white{255, 255, 255};

std::size_t place_of(CellEnd end) {
  return static_cast<std::size_t>(end);
}

struct MapRow {
  EnvelopeFamily family;
  std::vector<CellEnd> cells;
  std::vector<int> groups;  // EnvelopeCell::row of each
};

std::vector<MapRow> map_rows(const std::vector<CellResult>& results) {
  std::vector<MapRow> rows;
  for (const EnvelopeFamily& family : envelope_families()) {
    MapRow row{family, {}, {}};
    for (const CellResult& one : results)
      if (one.cell.family == family.name) {
        row.cells.push_back(one.verdict.end);
        row.groups.push_back(one.cell.row);
      }
    if (!row.cells.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::string squares_of(const MapRow& row) {
  constexpr std::size_t a_line = 56, indent = 14;
  std::string text;
  for (std::size_t k = 0; k < row.cells.size(); ++k) {
    if (k > 0 && k % a_line == 0) text += fmt::format("\n{:{}}", "", indent);
    text += letters[place_of(row.cells[k])];
  }
  return text;
}

std::string totals_of(const std::vector<CellResult>& results) {
  return fmt::format("{} cells: {} right (+), {} refused (r), {} stopped (s), {} failed (X)",
                     results.size(), count(results, CellEnd::right),
                     count(results, CellEnd::refused), count(results, CellEnd::stopped),
                     count(results, CellEnd::failed));
}

std::string command_for(const EnvelopeCell& cell) {
  std::string text = fmt::format("hackle run scripts/envelope/{}.lua", cell.family);
  for (const auto& [key, value] : cell.settings)
    text += " --set " + shell_word(fmt::format("{}={}", key, value));
  return text;
}

}  // namespace

std::string text_map(const std::vector<CellResult>& results) {
  std::string text;
  for (const MapRow& row : map_rows(results))
    fmt::format_to(std::back_inserter(text), "{:<12}  {}  {}\n", row.family.name, squares_of(row),
                   row.cells.size());
  text += totals_of(results) + "\n";
  for (const CellResult& one : results)
    if (one.verdict.end == CellEnd::failed)
      fmt::format_to(std::back_inserter(text), "failed: {}, {}\n  {}\n  {}\n", one.cell.family,
                     one.cell.name, hanging(one.verdict.why, 2, 80), command_for(one.cell));
  return text;
}

namespace {

// Lengths of the picture, px.
constexpr int widest = 1280, narrowest = 720, margin = 28, square = 15, gap = 3, group_gap = 9;
constexpr int names = 116, head = 96, sentence_height = 24;

struct MapPlace {
  int x = 0, y = 0;  // from the first square of the family
};

// Cells that vary the same options stand together.
std::vector<MapPlace> places_of(const MapRow& row) {
  std::vector<MapPlace> places;
  MapPlace next;
  for (std::size_t k = 0; k < row.cells.size(); ++k) {
    if (k > 0 && row.groups[k] != row.groups[k - 1] && next.x > 0) next.x += group_gap - gap;
    if (next.x + square > widest - names - 2 * margin) next = {0, next.y + square + gap};
    places.push_back(next);
    next.x += square + gap;
  }
  return places;
}

int height_of(const MapRow& row) {
  return places_of(row).back().y + square + sentence_height;
}

int width_of(const std::vector<MapRow>& rows) {
  int width = narrowest;
  for (const MapRow& row : rows)
    for (const MapPlace& place : places_of(row))
      width = std::max(width, place.x + square + names + 2 * margin);
  return width;
}

class MapDrawing {
 public:
  MapDrawing(int width, int height) : width_(width), image_(width, height), canvas_(image_) {
    canvas_.colour(paper_white);
    canvas_.fill(0, 0, width, height);
  }

  void write(const std::string& text, double x, double y, double size, Colour colour,
             double anchor = 0.0) {
    canvas_.write(font_, font_.place(text, x, y, size, anchor, colour));
  }

  double legend(const std::vector<CellResult>& results, double y) {
    double x = margin;
    for (const CellEnd end : ends) {
      const std::string text = fmt::format("{} {}", count(results, end), name_of(end));
      box(end, x, y - square + 3);
      write(text, x + square + 6, y, 14, ink);
      x += square + 30 + font_.width_of(text, 14);
    }
    return y;
  }

  void row(const MapRow& one, double top) {
    write(std::string(one.family.name), margin, top + square - 2, 15, ink);
    const std::vector<MapPlace> places = places_of(one);
    for (std::size_t k = 0; k < one.cells.size(); ++k)
      box(one.cells[k], margin + names + places[k].x, top + places[k].y);
    const std::string text = fmt::format("{}: {}", one.cells.size(), one.family.sentence);
    write(font_.fitting(text, 11.5, width_ - names - 2.0 * margin), margin + names,
          top + places.back().y + square + 14, 11.5, faint_ink);
  }

  Image finished() {
    canvas_.finish();
    return std::move(image_);
  }

 private:
  void box(CellEnd end, double x, double y) {
    canvas_.colour(colours[place_of(end)]);
    canvas_.fill(x, y, square, square);
    if (end == CellEnd::failed) write("x", x + 0.5 * square, y + square - 4, 14, paper_white, 0.5);
  }

  int width_;
  Image image_;
  Canvas canvas_;
  Font font_;
};

}  // namespace

Image picture_map(const std::vector<CellResult>& results) {
  const std::vector<MapRow> rows = map_rows(results);
  int height = head + margin;
  for (const MapRow& row : rows) height += height_of(row);
  MapDrawing drawing(width_of(rows), height);
  drawing.write(fmt::format("Envelope of stability, {} cells", results.size()), margin, 42, 22,
                ink);
  drawing.legend(results, 72);
  int top = head;
  for (const MapRow& row : rows) {
    drawing.row(row, top);
    top += height_of(row);
  }
  return drawing.finished();
}

}  // namespace hackle
