// SPDX-License-Identifier: MIT
#include "render/overlay/markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hackle {
namespace {

constexpr Colour ink{255, 255, 255}, rim{0, 0, 0};  // legible on any colour of a field

// The room taken by a marker, px.
struct Patch {
  double left, top, right, bottom;

  bool meets(const Patch& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool within(const Patch& other) const {
    return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
  }
};

double radius(const Layout& layout) {
  return std::max(2.5, std::round(0.22 * layout.small_font));
}

Patch box_around(const Vec2& place, double half) {
  return {place.x() - half, place.y() - half, place.x() + half, place.y() + half};
}

Patch box_of(const PlacedText& text, double width) {
  return {text.x - 2.0, text.y - 0.85 * text.size, text.x + width + 2.0, text.y + 0.3 * text.size};
}

bool is_seen(const Vec2& place, const Rectangle& plate) {
  return place.x() >= plate.x && place.x() <= plate.right() && place.y() >= plate.y &&
         place.y() <= plate.bottom();
}

// A possible position of a label relative to its point: offset along x and y, in units of the size,
// and the part of the label that lies there.
struct Side {
  double x, y, anchor;
};
constexpr auto sides = std::to_array<Side>({{0.75, 0.35, 0.0},
                                            {-0.75, 0.35, 1.0},
                                            {0.0, -0.8, 0.5},
                                            {0.0, 1.45, 0.5},
                                            {0.5, -0.8, 0.0},
                                            {0.5, 1.45, 0.0},
                                            {-0.5, -0.8, 1.0},
                                            {-0.5, 1.45, 1.0}});

// The area between caption and legend; for one of two plates, that plate only.
Patch room(const Layout& layout, const Rectangle& plate, double margin) {
  if (!layout.second_plate.empty())
    return {plate.x + margin, static_cast<double>(plate.y), plate.right() - margin,
            static_cast<double>(plate.bottom())};
  return {margin, static_cast<double>(layout.caption.bottom()), layout.width - margin,
          static_cast<double>(layout.foot)};
}

// Finds room for labels one after another.
class Placer {
 public:
  Placer(const Layout& layout, const Rectangle& plate, const Font& font)
      : font_(font), size_(layout.small_font), room_(room(layout, plate, 0.5 * size_)) {}

  void take(const Patch& box) { taken_.push_back(box); }

  std::optional<PlacedText> place(const std::string& label, const Vec2& at) {
    const std::string text = font_.fitting(label, size_, room_.right - room_.left - 4.0);
    const double width = font_.width_of(text, size_);
    for (const Side& side : sides) {
      const PlacedText placed = font_.place(text, at.x() + side.x * size_, at.y() + side.y * size_,
                                            size_, side.anchor, ink);
      const Patch box = box_of(placed, width);
      if (!box.within(room_) || meets_any(box)) continue;
      take(box);
      return placed;
    }
    return std::nullopt;
  }

 private:
  bool meets_any(const Patch& box) const {
    return std::ranges::any_of(taken_, [&](const Patch& other) { return box.meets(other); });
  }

  const Font& font_;
  double size_;
  Patch room_;
  std::vector<Patch> taken_;
};

}  // namespace

std::vector<PlacedMarker> place_markers(const std::vector<Marker>& markers, const Layout& layout,
                                        const Rectangle& plate, const Camera& camera,
                                        const Font& font) {
  Placer placer(layout, plate, font);
  std::vector<PlacedMarker> placed;
  std::vector<const std::string*> labels;
  for (const Marker& marker : markers) {
    const Vec2 place = camera.pixel(marker.place);
    if (!is_seen(place, plate)) continue;
    placer.take(box_around(place, radius(layout) + 1.0));
    placed.push_back({place, {}});
    labels.push_back(&marker.label);
  }
  for (std::size_t k = 0; k < placed.size(); ++k)
    placed[k].label = placer.place(*labels[k], placed[k].place);
  return placed;
}

void draw(Canvas& canvas, const std::vector<PlacedMarker>& markers, const Layout& layout,
          const Font& font) {
  for (const PlacedMarker& marker : markers) {
    canvas.colour(rim);
    canvas.dot(marker.place, radius(layout) + 1.0);
    canvas.colour(ink);
    canvas.dot(marker.place, radius(layout) - 0.5);
    if (marker.label) canvas.write(font, *marker.label, rim);
  }
}

}  // namespace hackle
