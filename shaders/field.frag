#version 330 core
// A field on the lattice in colours: one node is one cell, with sharp borders.

in vec2 place;  // 0..1 over the window
out vec4 colour;

uniform sampler2D field;       // one texel a node, row 0 at the bottom
uniform sampler2D damage;      // the same, 0..1, where cracks are to be seen as gaps
uniform sampler2D colour_map;  // one row
uniform vec2 origin;           // lower left corner of the window, in cells of the lattice
uniform vec2 cells;            // of the window, along x and y
uniform vec2 range;            // values at the two ends of the colour map; their logarithms if need be
uniform bool largest;          // what a pixel shows of many cells: their largest value, or the mean
uniform bool logarithmic;
uniform bool gaps;
uniform vec4 background;  // where there is no material, and beyond the plate

// Damage of both sides of a straight crack is 0.4 to 0.5.
const vec2 gap = vec2(0.25, 0.4);

struct Sample {
  float value;
  float damage;
  bool material;
};

// Taking one cell of those under a pixel would drop a crack one cell wide, and the mean would fade
// it: of damage it is always the largest.
Sample under_pixel() {
  vec2 half_pixel = 0.499 * vec2(dFdx(place.x), dFdy(place.y));
  ivec2 last = textureSize(field, 0) - 1;
  ivec2 from = max(ivec2(floor(origin + (place - half_pixel) * cells)), ivec2(0));
  ivec2 to = min(ivec2(floor(origin + (place + half_pixel) * cells)), last);
  float most = 0.0, sum = 0.0, broken = 0.0;
  int count = 0;
  for (int j = from.y; j <= to.y; ++j)
    for (int i = from.x; i <= to.x; ++i) {
      float value = texelFetch(field, ivec2(i, j), 0).r;
      if (isnan(value)) continue;
      most = count > 0 ? max(most, value) : value;
      sum += value;
      ++count;
      if (gaps) broken = max(broken, texelFetch(damage, ivec2(i, j), 0).r);
    }
  return Sample(largest ? most : sum / float(max(count, 1)), broken, count > 0);
}

void main() {
  Sample seen = under_pixel();
  // 0 has no logarithm; what is below the range has its least colour anyway.
  float value = logarithmic ? log(max(seen.value, 1e-30)) : seen.value;
  float share = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
  // From the centre of the first entry to the centre of the last.
  float entries = float(textureSize(colour_map, 0).x);
  vec4 entry = texture(colour_map, vec2((share * (entries - 1.0) + 0.5) / entries, 0.5));
  float open = gaps ? smoothstep(gap.x, gap.y, seen.damage) : 0.0;
  colour = seen.material ? mix(entry, background, open) : background;
}
