// SPDX-License-Identifier: MIT
#include "output/picture/crack_picture.hpp"

#include <fmt/format.h>

namespace hackle {

CrackDrawing crack_drawing(const CrackGraph& graph) {
  CrackDrawing drawing;
  for (const CrackPiece& piece : graph.cracks) drawing.paths.push_back(piece.points);
  for (const CrackTip& tip : graph.tips) {
    if (tip.state == TipState::arrived || tip.state == TipState::joined) continue;
    drawing.tips.push_back(
        {tip.place, tip.speed > 0.0 ? fmt::format("{:.0f} m/s", tip.speed) : std::string()});
  }
  return drawing;
}

CrackDrawing crack_drawing(const View& view) {
  CrackGrowth growth;
  growth.look(view);
  return crack_drawing(crack_graph(growth));
}

}  // namespace hackle
