// SPDX-License-Identifier: MIT
// What the module with OpenGL offers: the kernel as an OpenGL 4.5 compute program. Plain C, loaded at run
// time, so that the program links no OpenGL. All calls come from one thread.
#pragma once
#include <cstddef>
#include <cstdint>

extern "C" {

struct OpenGlTracer;

struct OpenGlBytes {
  const void* data;
  std::size_t size;
};

struct OpenGlScene {
  OpenGlBytes rows, tables, meshes, texels;  // texel buffers as scene.glsl binds them
  const std::uint32_t* constants;            // specialization constants by their id
  std::size_t constantCount;
  std::uint32_t width, height;  // film, pixels
  int software;                 // prefer a driver that runs on the CPU (1) or a GPU (0)
};

struct OpenGlText {
  char text[512];
};

/// Null: `message` says why in one line. Else it says what runs, *seconds what compiling took, *software
/// whether on the CPU.
using OpenGlOpen = OpenGlTracer*(const OpenGlScene* scene, OpenGlText* message, double* seconds,
                                 int* software);
using OpenGlClear = void(OpenGlTracer*);
/// One dispatch into half 0 or 1, awaited. `params`: TraceParams. 0: OK; else OpenGL's error.
using OpenGlDispatch = unsigned(OpenGlTracer*, const void* params, std::size_t bytes, std::uint32_t groupsX,
                                std::uint32_t groupsY, int half);
/// 4 integers per pixel each; the counters of both halves.
using OpenGlRead = void(OpenGlTracer*, int half, std::int32_t* low, std::int32_t* middle, std::int32_t* high,
                        std::uint32_t* counters);
using OpenGlClose = void(OpenGlTracer*);
}
