#version 330 core
// A field on the lattice in colours: one node is one cell, with sharp borders.

in vec2 place;  // 0..1 over the window
out vec4 colour;

uniform sampler2D field;       // one texel a node, row 0 at the bottom
uniform sampler2D colour_map;  // 256 x 1
uniform vec2 origin;           // lower left corner of the window, in cells of the lattice
uniform vec2 cells;            // of the window, along x and y
uniform vec2 range;            // values at the two ends of the colour map
uniform vec4 background;       // where there is no material, and beyond the plate

// The largest value under a pixel. A crack is a line one cell wide: taking one sample would drop it
// when cells are smaller than pixels, and averaging would fade it.
float largest_under_pixel(out bool material) {
  vec2 half_pixel = 0.499 * vec2(dFdx(place.x), dFdy(place.y));
  ivec2 last = textureSize(field, 0) - 1;
  ivec2 from = max(ivec2(floor(origin + (place - half_pixel) * cells)), ivec2(0));
  ivec2 to = min(ivec2(floor(origin + (place + half_pixel) * cells)), last);
  float most = 0.0;
  material = false;
  for (int j = from.y; j <= to.y; ++j)
    for (int i = from.x; i <= to.x; ++i) {
      float value = texelFetch(field, ivec2(i, j), 0).r;
      if (isnan(value)) continue;
      most = material ? max(most, value) : value;
      material = true;
    }
  return most;
}

void main() {
  bool material;
  float value = largest_under_pixel(material);
  float share = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
  // From the centre of the first entry to the centre of the last.
  vec4 entry = texture(colour_map, vec2((share * 255.0 + 0.5) / 256.0, 0.5));
  colour = material ? entry : background;
}
