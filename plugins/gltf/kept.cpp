// SPDX-License-Identifier: MIT
// What the scene has no place for, kept in extras under the key "gltf" for an exporter: see README.md.
#include "kept.hpp"

#include "open.hpp"

namespace gltf {

namespace {

Json parsed(const std::string& text) {
  return text.empty() ? Json()
                      : Json::parse(text);  // written by the library from JSON that was parsed before
}

/// Splits the extras of an element of ours into what an import kept and what is foreign.
void takeExtras(Json extras, Json& out) {
  if (extras.is_object()) {
    extras.erase("steradian");
    if (const auto kept = extras.find("gltf"); kept != extras.end() && kept->is_object()) {
      out.update(*kept);
      extras.erase("gltf");
    }
    if (extras.empty()) return;
  }
  if (!extras.is_null()) out["extras"] = std::move(extras);
}

}  // namespace

Json keptOf(const std::string& extensions, const std::string& extras, Json more) {
  Json out = Json::object();
  takeExtras(parsed(extras), out);
  out.update(more);
  if (const Json all = parsed(extensions); all.is_object())
    for (const auto& [name, value] : all.items())
      if (!knowsExtension(name)) out["extensions"][name] = value;
  return out;
}

std::string extrasText(const Json& kept) {
  return kept.empty() ? std::string() : Json{{"gltf", kept}}.dump();
}

std::string keptOfFile(const Document& document, Report& report) {
  const tinygltf::Model& model = document.model;
  Json more = Json::object();
  if (!model.asset.generator.empty()) more["generator"] = model.asset.generator;
  if (!model.asset.copyright.empty()) more["copyright"] = model.asset.copyright;
  Json unknown = Json::array();
  for (const std::string& name : model.extensionsUsed) {
    if (knowsExtension(name)) continue;
    unknown.push_back(name);
    report.exact("extension " + name, "has no effect here: unknown, kept for export");
  }
  if (!unknown.empty()) more["extensionsUsed"] = unknown;
  return extrasText(keptOf(model, std::move(more)));
}

}  // namespace gltf
