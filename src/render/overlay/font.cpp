// SPDX-License-Identifier: MIT
#include "render/overlay/font.hpp"

#include <algorithm>
#include <cmath>

#include <cairo-ft.h>
#include <fmt/format.h>

#include "base/error.hpp"

namespace hackle {
namespace {

// Returns the family of the face that Cairo found.
std::string family_of(cairo_scaled_font_t* font) {
  if (cairo_scaled_font_status(font) != CAIRO_STATUS_SUCCESS ||
      cairo_scaled_font_get_type(font) != CAIRO_FONT_TYPE_FT)
    return "";
  FT_Face face = cairo_ft_scaled_font_lock_face(font);
  std::string family = face != nullptr && face->family_name != nullptr ? face->family_name : "";
  if (face != nullptr) cairo_ft_scaled_font_unlock_face(font);
  return family;
}

bool is_utf8(cairo_scaled_font_t* font, const std::string& text) {
  cairo_glyph_t* glyphs = nullptr;
  int count = 0;
  const cairo_status_t status =
      cairo_scaled_font_text_to_glyphs(font, 0.0, 0.0, text.data(), static_cast<int>(text.size()),
                                       &glyphs, &count, nullptr, nullptr, nullptr);
  cairo_glyph_free(glyphs);
  return status == CAIRO_STATUS_SUCCESS;
}

// Control characters have no glyph, and Cairo stops drawing at invalid UTF-8.
std::string displayable(cairo_scaled_font_t* font, std::string text) {
  constexpr unsigned char blank = 0x20, erase = 0x7f;
  const auto is_control = [](unsigned char c) { return c < blank || c == erase; };
  std::ranges::replace_if(text, is_control, ' ');
  if (is_utf8(font, text)) return text;
  std::ranges::replace_if(
      text, [](unsigned char c) { return c > erase; }, '?');
  return text;
}

double advance(cairo_scaled_font_t* font, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_scaled_font_text_extents(font, text.c_str(), &extents);
  return extents.x_advance;
}

// Shortens UTF-8 text to at most `bytes` bytes, keeping characters whole.
void shorten(std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return;
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) --bytes;
  text.resize(bytes);
}

}  // namespace

Font::Font(const char* family)
    : face_(cairo_toy_font_face_create(family, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL),
            cairo_font_face_destroy) {
  constexpr double any_size = 16.0;
  if (family_of(scaled(any_size).get()) == family) return;
  throw Error(ErrorKind::files,
              fmt::format("pictures need the font {}, which is not installed", family),
              "install the Debian package fonts-dejavu-core");
}

Font::Scaled Font::scaled(double size) const {
  const std::unique_ptr<cairo_font_options_t, void (*)(cairo_font_options_t*)> options(
      cairo_font_options_create(), cairo_font_options_destroy);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_FULL);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_ON);
  cairo_matrix_t scale, identity;
  cairo_matrix_init_scale(&scale, size, size);
  cairo_matrix_init_identity(&identity);
  return {cairo_scaled_font_create(face_.get(), &scale, &identity, options.get()),
          cairo_scaled_font_destroy};
}

double Font::width_of(const std::string& text, double size) const {
  const Scaled font = scaled(size);
  return advance(font.get(), displayable(font.get(), text));
}

std::string Font::fitting(const std::string& text, double size, double width) const {
  constexpr double narrowest = 0.1;  // of all characters, in units of the size
  constexpr std::size_t widest_code = 4;
  const Scaled font = scaled(size);
  std::string shown = displayable(font.get(), text);
  if (advance(font.get(), shown) <= width) return shown;
  const double max = std::max(0.0, width) / (narrowest * size);
  shorten(shown, widest_code * static_cast<std::size_t>(max));
  while (!shown.empty() && advance(font.get(), shown + "…") > width)
    shorten(shown, shown.size() - 1);
  return shown.empty() ? shown : shown + "…";
}

PlacedText Font::place(const std::string& text, double x, double y, double size, double anchor,
                       Colour colour) const {
  const Scaled font = scaled(size);
  const std::string shown = displayable(font.get(), text);
  const double left = std::round(x - anchor * advance(font.get(), shown));
  return {shown, left, std::round(y), size, colour};
}

}  // namespace hackle
