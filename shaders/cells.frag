#version 330 core
// Every block of cells in its colour.

in vec2 at;
flat in vec4 shown;
out vec4 colour;

uniform sampler2D colours;  // one texel a block, row 0 at the bottom

void main() {
  // At the rim the middle of a pixel may lie outside of what is drawn.
  colour = texelFetch(colours, ivec2(clamp(floor(at), shown.xy, shown.zw)), 0);
}
