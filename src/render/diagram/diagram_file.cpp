// SPDX-License-Identifier: MIT
#include "render/diagram/diagram_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "measure/heading.hpp"
#include "render/png.hpp"
#include "render/vector_file.hpp"

namespace hackle {
namespace {

std::string as_identifier(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain || (!name.empty() && name.back() != '_')) name += plain ? c : '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return "value";
  return std::isdigit(static_cast<unsigned char>(name.front())) != 0 ? fmt::format("_{}", name)
                                                                     : name;
}

std::string heading_in_file(const std::string& name, const std::string& unit) {
  return heading_of(as_identifier(name), unit);
}

class Table {
 public:
  void add(const std::string& heading, const DiagramCurve& curve, int axis) {
    std::string name = heading;
    for (int number = 2; !taken_.insert(name).second; ++number)
      name = fmt::format("{}_{}", heading, number);
    columns_.push_back({std::move(name), &curve, axis});
  }

  std::string text() const {
    std::size_t rows = 0;
    std::string text;
    for (const Column& column : columns_) {
      rows = std::max(rows, column.curve->points.size());
      text += fmt::format("{}{}", text.empty() ? "" : ",", column.heading);
    }
    text += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        if (k > 0) text += ',';
        text += cell(columns_[k], row);
      }
      text += '\n';
    }
    return text;
  }

 private:
  struct Column {
    std::string heading;
    const DiagramCurve* curve;
    int axis;
  };

  static std::string cell(const Column& column, std::size_t row) {
    if (row >= column.curve->points.size()) return "";
    const double value = column.curve->points[row][column.axis];
    return std::isfinite(value) ? shortest(value) : "";
  }

  std::vector<Column> columns_;
  std::set<std::string> taken_;
};

bool share_x(const DiagramCurve& one, const DiagramCurve& other) {
  return std::ranges::equal(
      one.points, other.points, {}, [](const Vec2& p) { return p.x(); },
      [](const Vec2& p) { return p.x(); });
}

}  // namespace

void write_diagram(const Diagram& diagram, const DiagramStyle& style,
                   const std::filesystem::path& path) {
  const Theme& theme = theme_of(ground_of(style.look));
  const Font font;
  const DiagramDrawing drawing(diagram, style.size, theme, font);
  if (is_vector_file(path)) {
    write_vectors(path, {style.size.width, style.size.height, style.dpi},
                  [&](Canvas& canvas) { drawing.draw(canvas); });
    return;
  }
  Image image(style.size.width, style.size.height);
  {
    Canvas canvas(image);
    drawing.draw(canvas);
    canvas.finish();
  }
  write_png(image, path);
}

std::string csv_of(const Diagram& diagram) {
  Table table;
  const DiagramCurve* shared = nullptr;
  for (const DiagramCurve& curve : diagram.curves) {
    if (shared == nullptr || !share_x(*shared, curve))
      table.add(heading_in_file(diagram.x.name, diagram.x.unit), curve, 0);
    shared = &curve;
    const bool named = !curve.name.empty();
    table.add(heading_in_file(named ? curve.name : diagram.y.name, diagram.y.unit), curve, 1);
  }
  return table.text();
}

}  // namespace hackle
