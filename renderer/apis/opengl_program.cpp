// SPDX-License-Identifier: MIT
// #version, the constants as definitions, the text as cmake/GlslAsOpenGl.cmake wrote it.
#include "renderer/apis/opengl_program.hpp"

#include <GL/glcorearb.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace steradian::apis {
namespace {

#include "shaders/path_trace.opengl.glsl.text.h"

std::string definitions(std::span<const std::uint32_t> constants) {
  std::string text;
  for (std::size_t id = 0; id < constants.size(); ++id)
    text += "#define SPECIALIZED_" + std::to_string(id) + " " + std::to_string(constants[id]) + "u\n";
  return text;
}

std::string firstLine(const std::vector<char>& log) {
  const std::string text(log.data());
  return text.substr(0, text.find('\n'));
}

}  // namespace

unsigned compiledTracer(std::span<const std::uint32_t> constants) {
  const std::string values = definitions(constants);
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  const char* const parts[] = {"#version 450 core\n", values.c_str(), path_trace_opengl_text};
  glShaderSource(shader, 3, parts, nullptr);
  glCompileShader(shader);
  std::vector<char> log(4096);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
    throw std::runtime_error("OpenGL's compiler refuses the tracer: " + firstLine(log));
  }
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glDeleteShader(shader);
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (good) return program;
  glGetProgramInfoLog(program, GLsizei(log.size()), nullptr, log.data());
  throw std::runtime_error("OpenGL's linker refuses the tracer: " + firstLine(log));
}

}  // namespace steradian::apis
