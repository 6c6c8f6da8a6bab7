// SPDX-License-Identifier: MIT
// Texts, bars and charts around a plate and marks on it, drawn with Cairo on the pixels of a
// picture. What is the same on all pictures of a series is drawn once and copied.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/image.hpp"
#include "measure/field.hpp"
#include "render/camera.hpp"
#include "render/chart.hpp"
#include "render/colour_map.hpp"
#include "render/font.hpp"
#include "render/layout.hpp"
#include "render/markers.hpp"
#include "render/overlay_text.hpp"

namespace hackle {

// What an overlay shows at one time.
struct Moment {
  double time = 0.0;  // s
  std::vector<Circle> discs;
  Chart load_curve, energy;  // looked at where the layout has them
};

class Overlay {
 public:
  // A map for each bar of the text. A metre takes so many px along x. A bare layout has discs only.
  // Throws what Font throws.
  Overlay(const Layout& layout, const OverlayText& text, const std::vector<ColourMap>& maps,
          double pixels_a_metre);

  // On a picture of the layout's size, over whatever reaches beyond the plate there. A camera for
  // each of its plates. Moments of a
  // series are drawn in order: charts show what was drawn before.
  void draw(Image& image, const std::vector<Camera>& cameras, const Moment& moment);

  // All that was written by draw(), the last time it was called.
  std::vector<PlacedText> texts() const;

 private:
  struct Strip {
    Rectangle area;
    Image pixels;
  };

  void draw_once(const OverlayText& text, const std::vector<ColourMap>& maps,
                 double pixels_a_metre);
  void keep(const Rectangle& area, const std::function<void(Canvas&)>& draw_all);
  void write_caption(const OverlayText& text);
  void draw_marks(Image& image, const Rectangle& plate, const Camera& camera, const Moment& moment);
  void draw_fleeting(Image& image, const Moment& moment);
  void write_clock(double time);
  void draw_chart(Canvas& canvas, const Rectangle& room, ChartHistory& history, const Chart& chart,
                  double time);

  Layout layout_;
  Theme theme_;
  std::string slow_motion_;
  std::optional<Font> font_;  // nothing is written on a bare picture
  std::vector<Strip> strips_;
  std::vector<Marker> markers_;
  std::vector<PlacedMarker> placed_;  // of markers_, as they were drawn last
  ChartHistory loads_, energy_;
  std::vector<PlacedText> lasting_, fleeting_;
};

}  // namespace hackle
