// SPDX-License-Identifier: MIT
// Writes scene-linear radiance as OpenEXR, 32-bit float (or half), zip, with Rec. 709 chromaticities. Further
// layers follow as channels LAYER.NAME, always 32-bit: an object id or a sum of samples has no digit to lose.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <steradian/plugin.hpp>
#include <vector>

namespace {

namespace sdk = steradian::sdk;

constexpr sdk::ParameterInfo kParameters[] = {
    {.id = "half",
     .name = "half precision",
     .help = "16-bit floats: half the size, 3 digits, at most 65504",
     .type = sdk::ParameterType::boolean}};
constexpr float kLargestHalf = 65504.0f;
constexpr float kRec709[8] = {0.64f, 0.33f, 0.30f,   0.60f,
                              0.15f, 0.06f, 0.3127f, 0.3290f};  // r g b white, x y

std::span<const sdk::LayerRecord> layersOf(const sdk::ImageRecord& image) {
  return {image.layers, std::size_t(image.layerCount)};
}

/// R, G, B, then the channels of the layers.
std::vector<std::string> channelNames(const sdk::ImageRecord& image) {
  std::vector<std::string> names{"R", "G", "B"};
  for (const sdk::LayerRecord& layer : layersOf(image))
    for (std::uint32_t c = 0; c < layer.channelCount; ++c)
      names.push_back(layer.name.str() + "." + layer.channels[c].str());
  return names;
}

OIIO::ImageSpec specOf(const sdk::ImageRecord& image, bool half) {
  const std::vector<std::string> names = channelNames(image);
  OIIO::ImageSpec spec(int(image.width), int(image.height), int(names.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = names;
  if (half) {
    spec.channelformats.assign(names.size(), OIIO::TypeDesc::FLOAT);
    std::fill_n(spec.channelformats.begin(), 3, OIIO::TypeDesc::HALF);
  }
  if (half && names.size() == 3) spec.set_format(OIIO::TypeDesc::HALF);
  spec.attribute("DateTime", "");  // else OpenImageIO writes the time of day: the same picture, other bytes
  for (std::uint64_t i = 0; i < image.metadataCount; ++i)
    spec.attribute(image.metadata[i].key.str(), image.metadata[i].value.str());
  spec.attribute("compression", "zip");
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), kRec709);
  return spec;
}

class Exr final : public sdk::Exporter {
 public:
  Exr()
      : Exporter({.id = "org.steradian.exr",
                  .name = "OpenEXR",
                  .version = "1.0.0",
                  .extensions = ".exr",
                  .takesImage = 1,
                  .parameterCount = 1,
                  .parameters = kParameters}) {}

  void exportImage(sdk::Host& host, const sdk::ImageRecord& image, sdk::Writer& writer) override {
    if (!image.radiance) throw std::logic_error("needs scene-linear pixels");
    const bool half = host.parameter("half") != 0;
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output || !output->set_ioproxy(&memory)) throw std::runtime_error("OpenImageIO here has no OpenEXR");
    if (!output->open("image.exr", specOf(image, half))) throw std::runtime_error(output->geterror());
    writeRows(host, image, half, *output);
    // Only both together tell that every byte was taken.
    if (!output->close() || output->has_error()) throw std::runtime_error(output->geterror());
    writer.write(bytes.data(), bytes.size());
  }

 private:
  /// All channels of the rows [begin, end), pixel by pixel.
  static std::vector<float> interleaved(const sdk::ImageRecord& image, bool half, std::uint32_t begin,
                                        std::uint32_t end) {
    std::size_t channels = 3;
    for (const sdk::LayerRecord& layer : layersOf(image)) channels += layer.channelCount;
    const std::size_t first = std::size_t(begin) * image.width, last = std::size_t(end) * image.width;
    std::vector<float> out;
    out.reserve((last - first) * channels);
    for (std::size_t pixel = first; pixel < last; ++pixel) {
      for (std::size_t c = 0; c < 3; ++c) {
        const float v = image.radiance[pixel * 3 + c];
        // Beyond the range a half becomes infinite; NaN passes.
        out.push_back(!half ? v : v > kLargestHalf ? kLargestHalf : v < -kLargestHalf ? -kLargestHalf : v);
      }
      for (const sdk::LayerRecord& layer : layersOf(image))
        out.insert(out.end(), layer.pixels + pixel * layer.channelCount,
                   layer.pixels + (pixel + 1) * layer.channelCount);
    }
    return out;
  }

  static void writeRows(sdk::Host& host, const sdk::ImageRecord& image, bool half,
                        OIIO::ImageOutput& output) {
    constexpr std::uint32_t kRows = 64;  // whole zip blocks of 16, short enough to cancel
    for (std::uint32_t y = 0; y < image.height; y += kRows) {
      if (host.cancelled()) throw sdk::Cancelled{};
      host.progress(double(y) / image.height);
      const std::uint32_t end = std::min(y + kRows, image.height);
      const std::vector<float> rows = interleaved(image, half, y, end);
      if (!output.write_scanlines(int(y), int(end), 0, OIIO::TypeDesc::FLOAT, rows.data()))
        throw std::runtime_error(output.geterror());
    }
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<Exr>();
}
