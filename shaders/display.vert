#version 460
// SPDX-License-Identifier: MIT
// A quad over the viewport rectangle from the vertex index alone: nothing to upload (thesis, section 3.1.3).
void main() {
  vec2 corner = vec2(float(gl_VertexIndex & 1), float(gl_VertexIndex >> 1));
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
