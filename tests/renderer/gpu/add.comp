#version 460
// SPDX-License-Identifier: MIT
// What the tests of the compute pass run: sum[i] = rows[i].x + storage[i] + push + constant.
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kConstant = 0;
layout(constant_id = 3) const bool kDouble = false;
layout(set = 0, binding = 0) uniform samplerBuffer rows;
layout(set = 0, binding = 1) readonly buffer Values { float values[]; };
layout(set = 0, binding = 2) buffer Sums { float sums[]; };
layout(push_constant) uniform Push { float offset; uint count; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  float sum = texelFetch(rows, int(i)).x + values[i] + offset + float(kConstant);
  sums[i] = kDouble ? 2.0 * sum : sum;
}
