// SPDX-License-Identifier: MIT
// The colours of a field and the values they stand for.
#pragma once

#include <vector>

#include "render/overlay/canvas.hpp"
#include "render/overlay/layout.hpp"

namespace hackle {

// At which ends of a bar there are values beyond it.
struct Beyond {
  bool below = false, above = false;
};

class ColourBar {
 public:
  ColourBar(const Layout& layout, const BarRoom& room, const BarText& text, const Theme& theme,
            const Font& font);

  void draw(Canvas& canvas, const ColourMap& map) const;
  // Draws a triangle at each end that values lie beyond, in the colour they have.
  void draw_ends(Canvas& canvas, const ColourMap& map, const Beyond& beyond) const;
  // Returns the name, the remark and the numbers.
  const std::vector<PlacedText>& texts() const { return texts_; }

 private:
  void draw_end(Canvas& canvas, Colour colour, int from, int towards) const;

  Rectangle bar_;
  int mark_ = 0, hairline_ = 1;  // px, length and width of marks
  std::vector<int> marks_;       // px from the left
  std::vector<PlacedText> texts_;
  Colour colour_;
};

}  // namespace hackle
