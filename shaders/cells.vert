#version 330 core
// Corners of blocks of cells, four a block.

layout(location = 0) in vec2 place;  // -1..1 over the viewport
flat out int block;

void main() {
  block = gl_VertexID / 4;
  gl_Position = vec4(place, 0.0, 1.0);
}
