// SPDX-License-Identifier: MIT
// A finished still as a file, with what it takes to judge and repeat it written inside.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plugins/host/plugin_host.hpp"
#include "renderer/renderer.hpp"

namespace steradian {

/// What the metadata of an image says about how it was made.
struct StillOrigin {
  std::string project;  // name or path
  std::string device;
  std::uint32_t seed = 0;
  std::uint64_t sampleBegin = 0;
  RenderStats stats;
  bool partial = false;  // ended before its target
};

/// Keys "steradian:project", "steradian:samples" ...; values as text.
std::map<std::string, std::string> metadataOf(const StillOrigin& origin);

/// Throws Error(usage) when no exporter writes images of this extension (the message lists the extensions),
/// Error(io) when the folder does not exist: call it before hours of rendering.
void checkStillPath(const plugins::PluginHost& host, const std::filesystem::path& path);

/// What a file holds beside the picture, where its format can: AOVs, the sums of a part.
struct StillExtras {
  std::vector<plugins::ImageLayer> layers;
  std::map<std::string, std::string> metadata;  // wins over what metadataOf() says
  std::optional<Image> radiance = {};           // instead of the renderer's, where parts must agree on it
};

/// The accumulated sums, from which `steradian merge` puts disjoint ranges of samples together without loss.
/// Throws Error(failed) when they are not whole: see StillRequest::wholePasses.
StillExtras partExtras(Renderer& renderer, const StillOrigin& origin);

/// Writes the renderer's picture, display-encoded with its present tonemapper where the format wants that.
/// Throws Error(io | plugin); an older file of that name stays then.
void saveStill(const plugins::PluginHost& host, Renderer& renderer, const StillOrigin& origin,
               const std::vector<std::filesystem::path>& paths, const plugins::Parameters& parameters = {},
               const StillExtras& extras = {});

}  // namespace steradian
