// SPDX-License-Identifier: MIT
// Writes scene-linear radiance as OpenEXR, 32-bit float (or half), zip, with Rec. 709 chromaticities.
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

OIIO::ImageSpec specOf(const sdk::ImageRecord& image, bool half) {
  OIIO::ImageSpec spec(int(image.width), int(image.height), 3,
                       half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
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
  static void writeRows(sdk::Host& host, const sdk::ImageRecord& image, bool half,
                        OIIO::ImageOutput& output) {
    constexpr std::uint32_t kRows = 64;  // whole zip blocks of 16, short enough to cancel
    std::vector<float> rows;
    for (std::uint32_t y = 0; y < image.height; y += kRows) {
      if (host.cancelled()) throw sdk::Cancelled{};
      host.progress(double(y) / image.height);
      const std::uint32_t end = std::min(y + kRows, image.height);
      const std::size_t stride = std::size_t(image.width) * 3;
      rows.assign(image.radiance + y * stride, image.radiance + end * stride);
      if (half)  // beyond the range a half becomes infinite; NaN passes
        for (float& v : rows) v = v > kLargestHalf ? kLargestHalf : v < -kLargestHalf ? -kLargestHalf : v;
      if (!output.write_scanlines(int(y), int(end), 0, OIIO::TypeDesc::FLOAT, rows.data()))
        throw std::runtime_error(output.geterror());
    }
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<Exr>();
}
