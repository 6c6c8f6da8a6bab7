#version 330 core
// Every block of cells in its colour.

flat in int block;
out vec4 colour;

uniform sampler2D colours;  // one texel a block, row 0 at the bottom

void main() {
  int columns = textureSize(colours, 0).x;
  colour = texelFetch(colours, ivec2(block % columns, block / columns), 0);
}
