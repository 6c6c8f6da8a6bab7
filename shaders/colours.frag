#version 330 core
// Turns the values of one field, or of two, into colours: one texel per fragment.

out vec4 colour;

uniform sampler2D values;      // row 0 at the bottom; nan without material
uniform sampler2D second;      // of a second field, if there is one
uniform sampler2D damage;      // 0..1, if cracks are shown as gaps
uniform sampler2D colour_map;  // one row
uniform sampler2D second_map;
uniform vec2 range;         // values at the two ends of the colour map, or their logarithms
uniform vec2 second_range;
uniform bool logarithmic;
uniform bool second_logarithmic;
uniform int arrangement;  // place of the second field: 0 nowhere, 1 below and 2 right of `split`,
                          // 3 over the first, more opaque for larger values
uniform vec2 split;       // texels
uniform bool gaps;
uniform vec4 background;  // shown without material; premultiplied
uniform vec4 gap_colour;  // shown in cracks; premultiplied
uniform vec2 corner;      // of the drawn area, px

// Damage of both sides of a straight crack is 0.4 to 0.5.
const vec2 gap = vec2(0.25, 0.4);

float share(float value, vec2 ends, bool is_logarithmic) {
  // 0 has no logarithm; values below the range have its lowest colour in any case.
  float at = is_logarithmic ? log(max(value, 1e-30)) : value;
  return clamp((at - ends.x) / (ends.y - ends.x), 0.0, 1.0);
}

vec4 entry(sampler2D map, float share_of_range) {
  float last = float(textureSize(map, 0).x - 1);
  float place = share_of_range * last;
  float below = min(floor(place), last - 1.0);
  vec4 one = texelFetch(map, ivec2(below, 0), 0);
  vec4 other = texelFetch(map, ivec2(below + 1.0, 0), 0);
  return mix(one, other, place - below);
}

bool shows_second(vec2 place) {
  return (arrangement == 1 && place.y < split.y) || (arrangement == 2 && place.x > split.x);
}

vec4 of_second(ivec2 at, out float opacity) {
  opacity = share(texelFetch(second, at, 0).r, second_range, second_logarithmic);
  return entry(second_map, opacity);
}

void main() {
  vec2 place = gl_FragCoord.xy - corner;
  ivec2 at = ivec2(place);
  float value = texelFetch(values, at, 0).r;
  float opacity = 0.0;
  if (shows_second(place))
    colour = of_second(at, opacity);
  else
    colour = entry(colour_map, share(value, range, logarithmic));
  if (arrangement == 3) {
    vec4 over = of_second(at, opacity);
    colour = mix(colour, over, opacity);
  }
  float open = gaps ? smoothstep(gap.x, gap.y, texelFetch(damage, at, 0).r) : 0.0;
  colour = isnan(value) ? background : mix(colour, gap_colour, open);
}
