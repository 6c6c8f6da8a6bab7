// SPDX-License-Identifier: MIT
// Texts, bars and charts around a plate and marks on it, drawn with Cairo on the pixels of a
// picture, or as vectors. Parts that all pictures of a series share are drawn once and copied.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/image.hpp"
#include "measure/field.hpp"
#include "render/camera.hpp"
#include "render/colour_map.hpp"
#include "render/overlay/chart.hpp"
#include "render/overlay/colour_bar.hpp"
#include "render/overlay/crack_drawing.hpp"
#include "render/overlay/font.hpp"
#include "render/overlay/layout.hpp"
#include "render/overlay/markers.hpp"
#include "render/overlay/overlay_text.hpp"
#include "render/overlay/scale_bar.hpp"

namespace hackle {

// The content of an overlay at one time.
struct Moment {
  double time = 0.0;  // s
  std::vector<Circle> discs;
  Chart load_curve, energy;         // used if the layout has room for them
  std::vector<Beyond> beyond = {};  // for each bar; none if there is nothing beyond
  std::vector<Box> boxes = {};
  CrackDrawing cracks = {};
};

class Overlay {
 public:
  // Takes a colour map for each bar of the text, and px per metre along x. A bare layout shows only
  // discs. Throws what Font throws.
  Overlay(const Layout& layout, const OverlayText& text, const std::vector<ColourMap>& maps,
          double pixels_a_metre);

  // Changes the colour bars of the pictures to come.
  void set_bars(const std::vector<BarText>& bars, const std::vector<ColourMap>& maps);

  // Changes the scale bar of the pictures to come.
  void set_scale(double pixels_a_metre);

  // Draws on a picture of the layout's size, over anything there that extends beyond the plate.
  // Takes a camera per plate. Moments of a series must be drawn in order: charts show the earlier
  // ones.
  void draw(Image& image, const std::vector<Camera>& cameras, const Moment& moment);

  // Draws the same as vectors on a page with the ground and the plates.
  void draw(Canvas& canvas, const std::vector<Camera>& cameras, const Moment& moment);

  // Returns all texts of the last draw().
  std::vector<PlacedText> texts() const;

 private:
  struct Strip {
    Rectangle area;
    Image pixels;
  };

  void draw_once();
  void draw_lasting(Canvas& canvas) const;
  void keep(const Rectangle& area, const std::function<void(Canvas&)>& draw_all);
  void write_caption();
  void draw_all_marks(Canvas& canvas, const std::vector<Camera>& cameras, const Moment& moment);
  void draw_marks(Canvas& canvas, const Rectangle& plate, const Camera& camera,
                  const Moment& moment);
  void draw_axes(Canvas& canvas, const Rectangle& plate, const Camera& camera);
  void draw_fleeting(Canvas& canvas, const Moment& moment);
  void write_clock(double time);
  void draw_chart(Canvas& canvas, const Rectangle& room, ChartHistory& history, const Chart& chart,
                  double time);

  Layout layout_;
  OverlayText text_;
  std::vector<ColourMap> maps_;
  double pixels_a_metre_;
  Theme theme_;
  std::string slow_motion_;
  std::optional<Font> font_;  // empty on a bare picture, which has no text
  std::vector<ColourBar> bars_;
  std::optional<ScaleBar> scale_;
  std::vector<Strip> strips_;
  std::vector<PlacedMarker> placed_;  // of the markers, as last drawn
  ChartHistory loads_, energy_;
  std::vector<PlacedText> lasting_, fleeting_;
};

}  // namespace hackle
