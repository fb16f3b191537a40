// SPDX-License-Identifier: MIT
// What the scene has no place for, kept in extras under the key "gltf" for an exporter: see README.md.
#pragma once
#include "document.hpp"

namespace gltf {

/// {"extras": ..., "extensions": the unknown ones}, as far as there are any, from the texts that tinygltf
/// stored, plus what an earlier import had kept, plus `more`. The exporter's own "steradian" is not among it:
/// see restore.hpp.
Json keptOf(const std::string& extensions, const std::string& extras, Json more = Json::object());

template <class Element>
Json keptOf(const Element& element, Json more = Json::object()) {
  return keptOf(element.extensions_json_string, element.extras_json_string, std::move(more));
}

/// {"gltf": kept} as text, or nothing.
std::string extrasText(const Json& kept);

/// Of the file as a whole; unknown extensions go to the report as well.
std::string keptOfFile(const Document& document, Report& report);

}  // namespace gltf
