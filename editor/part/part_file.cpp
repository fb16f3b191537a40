// SPDX-License-Identifier: MIT
// Parts as layers and metadata of an image file.
#include <algorithm>
#include <charconv>

#include "editor/part/part.hpp"

namespace steradian {

namespace {

constexpr const char* kRgb[] = {"R", "G", "B"};
constexpr char kBetweenDevices = '\n';

std::string layerName(int half, std::size_t term) {
  return std::string(half == 0 ? "sumA." : "sumB.") + std::to_string(term);
}

/// Metadata of one file, read strictly.
class Fields {
 public:
  Fields(const std::string& file, const std::map<std::string, std::string>& metadata)
      : file_(file), metadata_(metadata) {}

  std::string text(const std::string& key) const {
    const auto found = metadata_.find("steradian:" + key);
    if (found == metadata_.end()) notAPart("it lacks steradian:" + key);
    return found->second;
  }
  std::uint64_t number(const std::string& key) const {
    const std::string value = text(key);
    std::uint64_t out = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), out);
    if (error != std::errc() || end != value.data() + value.size())
      notAPart("steradian:" + key + " is '" + value + "', not a whole number");
    return out;
  }
  [[noreturn]] void notAPart(const std::string& why) const {
    throw Error(ExitCode::badInput, file_ + ": is no part of a render: " + why +
                                        "; parts are made by steradian render --samples A:B -o PART.exr");
  }

 private:
  const std::string& file_;
  const std::map<std::string, std::string>& metadata_;
};

PartOrigin originOf(const Fields& fields) {
  PartOrigin origin;
  origin.scene = fields.text("scene");
  origin.version = fields.text("version");
  origin.project = fields.text("project");
  origin.seed = std::uint32_t(fields.number("seed"));
  origin.errorMeter = fields.text("part") == "halves";
  origin.begin = fields.number("sampleBegin");
  origin.end = origin.begin + fields.number("samples");
  origin.nan = fields.number("nan");
  const std::string devices = fields.text("device");
  for (std::size_t at = 0; at <= devices.size();) {
    const std::size_t end = std::min(devices.find(kBetweenDevices, at), devices.size());
    origin.devices.insert(devices.substr(at, end - at));
    at = end + 1;
  }
  if (origin.begin >= origin.end) fields.notAPart("it holds no sample");
  return origin;
}

/// Some channels of an image.
Image channelsOf(const Image& pixels, const std::vector<std::size_t>& channels) {
  const std::size_t count = std::size_t(pixels.width) * pixels.height, wanted = channels.size();
  Image out{pixels.width, pixels.height, int(wanted), std::vector<float>(count * wanted)};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < wanted; ++c)
      out.pixels[i * wanted + c] = pixels.pixels[i * std::size_t(pixels.channels) + channels[c]];
  return out;
}

/// The layers that hold neither the picture nor its sums, by name.
std::vector<plugins::ImageLayer> otherLayers(const Image& pixels,
                                             const std::vector<std::string>& channelNames) {
  std::map<std::string, std::vector<std::size_t>> channels;
  for (std::size_t i = 0; i < channelNames.size(); ++i) {
    const std::string layer = channelNames[i].substr(0, channelNames[i].rfind('.'));
    if (layer != channelNames[i] && !layer.starts_with("sumA.") && !layer.starts_with("sumB."))
      channels[layer].push_back(i);
  }
  std::vector<plugins::ImageLayer> layers;
  for (const auto& [name, from] : channels) {
    layers.push_back({name, channelsOf(pixels, from), {}});
    for (const std::size_t i : from)
      layers.back().channelNames.push_back(channelNames[i].substr(name.size() + 1));
  }
  return layers;
}

}  // namespace

std::vector<plugins::ImageLayer> layersOf(const Part& part) {
  std::vector<plugins::ImageLayer> layers;
  for (int half = 0; half < 2; ++half)
    for (std::size_t k = 0; k < part.terms[half].size(); ++k)
      layers.push_back({layerName(half, k), part.terms[half][k], {kRgb, kRgb + 3}});
  layers.insert(layers.end(), part.layers.begin(), part.layers.end());
  return layers;
}

std::map<std::string, std::string> partMetadata(const PartOrigin& origin) {
  std::string devices;
  for (const std::string& device : origin.devices) {
    if (!devices.empty()) devices += kBetweenDevices;
    devices += device;
  }
  return {{"steradian:scene", origin.scene},
          {"steradian:version", origin.version},
          {"steradian:project", origin.project},
          {"steradian:seed", std::to_string(origin.seed)},
          {"steradian:part", origin.errorMeter ? "halves" : "joint"},
          {"steradian:sampleBegin", std::to_string(origin.begin)},
          {"steradian:samples", std::to_string(origin.end - origin.begin)},
          {"steradian:nan", std::to_string(origin.nan)},
          {"steradian:device", devices}};
}

Part readPart(const std::string& file, const Image& pixels, const std::vector<std::string>& channelNames,
              const std::map<std::string, std::string>& metadata) {
  const Fields fields(file, metadata);
  Part part{originOf(fields), pixels.width, pixels.height, {}, otherLayers(pixels, channelNames)};
  const auto channel = [&](const std::string& name) {
    return std::size_t(std::find(channelNames.begin(), channelNames.end(), name) - channelNames.begin());
  };
  for (int half = 0; half < (part.origin.errorMeter ? 2 : 1); ++half)
    for (std::size_t k = 0; channel(layerName(half, k) + ".R") < channelNames.size(); ++k) {
      std::vector<std::size_t> from;
      for (const char* name : kRgb) from.push_back(channel(layerName(half, k) + "." + name));
      if (*std::ranges::max_element(from) >= channelNames.size())
        fields.notAPart("the layer " + layerName(half, k) + " lacks a channel");
      part.terms[half].push_back(channelsOf(pixels, from));
    }
  for (int half = 0; half < (part.origin.errorMeter ? 2 : 1); ++half)
    if (part.terms[half].empty()) fields.notAPart("it lacks the layer " + layerName(half, 0));
  return part;
}

}  // namespace steradian
