// SPDX-License-Identifier: MIT
// The one place where tinygltf is compiled.
#include <fstream>  // its writer, which is not called, names it

#define TINYGLTF_IMPLEMENTATION
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "tinygltf.hpp"
