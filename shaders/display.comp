// SPDX-License-Identifier: MIT
// The film pixel by pixel, for stills: no window, no graphics queue. display.glsl stands before this.
layout(local_size_x = 64) in;
layout(set = 0, binding = 6) writeonly buffer Encoded { vec4 encoded[]; };

void main() {
  uint at = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
  if (at < display.width * display.height) encoded[at] = vec4(encodedPixel(at), 1.0);
}
