// SPDX-License-Identifier: MIT
// What every test kernel shares: rows of questions at binding 6, rows of answers at binding 7, and an operation
// number that is compiled in. Binding 0 stays free for scene rows.
#ifndef KERNEL_GLSL
#define KERNEL_GLSL

layout(local_size_x = 64) in;
layout(constant_id = 64) const uint kOperation = 0u;
layout(set = 0, binding = 6) readonly buffer Questions { vec4 questions[]; };
layout(set = 0, binding = 7) writeonly buffer Answers { vec4 answers[]; };

uint invocation() {
  return gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x;
}

#endif
