// SPDX-License-Identifier: MIT
// The kernel's buffers and dispatches.
#include "renderer/apis/opengl_module.hpp"

#include <GL/glcorearb.h>

#include <array>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string>

#include "renderer/apis/egl_context.hpp"
#include "renderer/apis/opengl_program.hpp"
#include "renderer/stopwatch.hpp"

namespace {

using steradian::secondsSince;
using steradian::apis::EglContext;

constexpr std::size_t paramsBytes = 128;  // of TraceParams
constexpr std::size_t counterBytes = 16;  // COUNTERS
constexpr GLuint digitsBinding = 1, texelsBinding = 11, digits = 3,
                 countersBinding = 5;  // of a half: low, middle, high

GLuint buffer(const void* data, std::size_t size) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  glNamedBufferStorage(name, GLsizeiptr(size), data, GL_DYNAMIC_STORAGE_BIT);
  return name;
}

/// Into texture unit `binding`. An empty one holds a zero.
void bindTexels(GLuint binding, GLenum format, std::size_t texel, OpenGlBytes bytes) {
  constexpr std::array<std::uint32_t, 4> nothing{};
  if (bytes.size == 0) bytes = {nothing.data(), sizeof nothing};
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (bytes.size / texel > std::size_t(most))
    throw std::runtime_error("the scene needs a texel buffer of " + std::to_string(bytes.size / texel) +
                             " texels, this OpenGL driver stops at " + std::to_string(most));
  GLuint texture = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
  glTextureBuffer(texture, format, buffer(bytes.data, bytes.size));
  glBindTextureUnit(binding, texture);
}

}  // namespace

/// Objects of OpenGL die with the context.
struct OpenGlTracer {
  explicit OpenGlTracer(const OpenGlScene& scene)
      : context(scene.software != 0), filmBytes(std::size_t(scene.width) * scene.height * 16) {
    bindTexels(0, GL_RGBA32F, 16, scene.rows);
    bindTexels(8, GL_RGBA32F, 16, scene.tables);
    bindTexels(9, GL_RGBA32F, 16, scene.meshes);
    bindTexels(10, GL_R32UI, 4, scene.texels);
    glCreateTextures(GL_TEXTURE_BUFFER, GLsizei(films.size()), filmTexels.data());
    for (std::size_t i = 0; i < films.size(); ++i) {
      films[i] = buffer(nullptr, filmBytes);
      glTextureBuffer(filmTexels[i], GL_RGBA32I, films[i]);
    }
    counters = buffer(nullptr, counterBytes);
    params = buffer(nullptr, paramsBytes);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, countersBinding, counters);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, params);
    const auto start = std::chrono::steady_clock::now();
    glUseProgram(steradian::apis::compiledTracer({scene.constants, scene.constantCount}));
    // Some drivers only compile to machine code at the first dispatch; this one touches no pixel.
    const std::array<std::uint8_t, paramsBytes> nothing{};
    clear();
    if (const GLenum error = dispatch(nothing.data(), nothing.size(), 1, 1, 0))
      throw std::runtime_error("OpenGL: the first dispatch failed with error " + std::to_string(error));
    compileSeconds = secondsSince(start);
  }

  void clear() const {
    for (const GLuint film : films)
      glClearNamedBufferData(film, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    glClearNamedBufferData(counters, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  }

  GLenum dispatch(const void* data, std::size_t bytes, GLuint groupsX, GLuint groupsY, int half) const {
    glNamedBufferSubData(params, 0, GLsizeiptr(bytes), data);
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, digitsBinding, digits, &films[digits * GLuint(half)]);
    glBindTextures(texelsBinding, digits, &filmTexels[digits * GLuint(half)]);
    glDispatchCompute(groupsX, groupsY, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glFinish();
    return glGetError();
  }

  EglContext context;
  std::size_t filmBytes;
  std::array<GLuint, 2 * digits> films{}, filmTexels{};  // of half A, then B
  GLuint counters = 0, params = 0;
  double compileSeconds = 0.0;
};

namespace {

void write(OpenGlText& text, const std::string& message) {
  std::strncpy(text.text, message.c_str(), sizeof text.text - 1);
}

}  // namespace

#define EXPORTED extern "C" [[gnu::visibility("default")]]

EXPORTED OpenGlTracer* steradianOpenGlOpen(const OpenGlScene* scene, OpenGlText* message, double* seconds,
                                           int* software) try {
  auto* tracer = new OpenGlTracer(*scene);
  write(*message, tracer->context.runsOn());
  *seconds = tracer->compileSeconds;
  *software = tracer->context.runsOnCpu() ? 1 : 0;
  return tracer;
} catch (const std::exception& error) {
  write(*message, error.what());
  return nullptr;
}

EXPORTED void steradianOpenGlClear(OpenGlTracer* tracer) {
  tracer->context.use();
  tracer->clear();
}

EXPORTED unsigned steradianOpenGlDispatch(OpenGlTracer* tracer, const void* params, std::size_t bytes,
                                          std::uint32_t groupsX, std::uint32_t groupsY, int half) {
  return tracer->dispatch(params, bytes, groupsX, groupsY, half);
}

EXPORTED void steradianOpenGlRead(OpenGlTracer* tracer, int half, std::int32_t* low, std::int32_t* middle,
                                  std::int32_t* high, std::uint32_t* counters) {
  const GLuint* film = &tracer->films[digits * GLuint(half)];
  for (std::int32_t* read : {low, middle, high})
    glGetNamedBufferSubData(*film++, 0, GLsizeiptr(tracer->filmBytes), read);
  glGetNamedBufferSubData(tracer->counters, 0, counterBytes, counters);
}

EXPORTED void steradianOpenGlClose(OpenGlTracer* tracer) {
  delete tracer;
}
