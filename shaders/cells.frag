#version 330 core
// Paints every block of cells in its colour.

in vec2 at;
flat in vec4 shown;
out vec4 colour;

uniform sampler2D colours;  // one texel per block, row 0 at the bottom

void main() {
  // At the rim the centre of a pixel may lie outside the drawn area.
  colour = texelFetch(colours, ivec2(clamp(floor(at), shown.xy, shown.zw)), 0);
}
