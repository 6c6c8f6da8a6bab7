#version 330 core
// Values in colours, one texel for one fragment.

out vec4 colour;

uniform sampler2D values;      // row 0 at the bottom; nan where there is no material
uniform sampler2D damage;      // the same, 0..1, where cracks are to be seen as gaps
uniform sampler2D colour_map;  // one row
uniform vec2 range;            // values at the two ends of the colour map; their logarithms if need be
uniform bool logarithmic;
uniform bool gaps;
uniform vec4 background;  // where there is no material; premultiplied

// Damage of both sides of a straight crack is 0.4 to 0.5.
const vec2 gap = vec2(0.25, 0.4);

vec4 entry(float value) {
  // 0 has no logarithm; what is below the range has its least colour anyway.
  float at = logarithmic ? log(max(value, 1e-30)) : value;
  float share = clamp((at - range.x) / (range.y - range.x), 0.0, 1.0);
  float last = float(textureSize(colour_map, 0).x - 1);
  float place = share * last;
  float below = min(floor(place), last - 1.0);
  vec4 one = texelFetch(colour_map, ivec2(below, 0), 0);
  vec4 other = texelFetch(colour_map, ivec2(below + 1.0, 0), 0);
  return mix(one, other, place - below);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float value = texelFetch(values, at, 0).r;
  float open = gaps ? smoothstep(gap.x, gap.y, texelFetch(damage, at, 0).r) : 0.0;
  colour = isnan(value) ? background : mix(entry(value), background, open);
}
