#version 330 core
// Corners of quadrilaterals, each of which shows one or more blocks of cells.

layout(location = 0) in vec2 place;   // -1..1 over the viewport
layout(location = 1) in vec2 point;   // in blocks
layout(location = 2) in vec4 blocks;  // first column and row, last column and row
out vec2 at;
flat out vec4 shown;

void main() {
  at = point;
  shown = blocks;
  gl_Position = vec4(place, 0.0, 1.0);
}
