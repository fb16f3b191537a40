// SPDX-License-Identifier: MIT
// A tonemapper is one annotated GLSL text: no shared object, no build.
#pragma once
#include <string>
#include <string_view>

#include "plugins/host/plugin_host.hpp"

namespace steradian::plugins {

/// Reads the `// @id`, `// @name`, `// @version` and `// @param TYPE NAME DEFAULT MIN MAX "unit" "help"`
/// lines; TYPE is float, int or bool (`// @param bool NAME DEFAULT`). Throws std::runtime_error "line 3:
/// ...".
Contribution parseTonemapper(std::string_view glsl);

}  // namespace steradian::plugins
