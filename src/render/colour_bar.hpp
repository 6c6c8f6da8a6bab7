// SPDX-License-Identifier: MIT
// The colours of a field and what values they stand for.
#pragma once

#include <vector>

#include "render/canvas.hpp"
#include "render/layout.hpp"

namespace hackle {

class ColourBar {
 public:
  ColourBar(const Layout& layout, const BarRoom& room, const BarText& text, const Theme& theme,
            const Font& font);

  void draw(Canvas& canvas, const ColourMap& map) const;
  // The name and the numbers.
  const std::vector<PlacedText>& texts() const { return texts_; }

 private:
  Rectangle bar_;
  int mark_ = 0, hairline_ = 1;  // px, how long and wide marks are
  std::vector<int> marks_;       // px from the left
  std::vector<PlacedText> texts_;
  Colour colour_;
};

}  // namespace hackle
