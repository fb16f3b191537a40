// SPDX-License-Identifier: MIT
// Writes display-encoded pixels as PNG: 8 bits with dither, or 16 bits.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <steradian/plugin.hpp>
#include <vector>

namespace {

namespace sdk = steradian::sdk;

constexpr sdk::ParameterInfo kParameters[] = {{.id = "bitDepth",
                                               .name = "bits per channel",
                                               .unit = "bit",
                                               .help = "8 (dithered) or 16",
                                               .type = sdk::ParameterType::integer,
                                               .defaultValue = 8,
                                               .minimum = 8,
                                               .maximum = 16}};

/// Two uniform numbers in [0, 1) for one value of one pixel: the same picture gives the same bytes.
/// PCG's output permutation (O'Neill 2014) on the value's index.
struct Uniforms {
  float a, b;
};
Uniforms uniformsAt(std::uint64_t index) {
  std::uint64_t state = index * 6364136223846793005ull + 1442695040888963407ull;
  state = ((state >> ((state >> 59) + 5)) ^ state) * 12605985483714917081ull;
  state ^= state >> 43;
  return {float(state >> 40) * 0x1p-24f, float((state >> 16) & 0xffffff) * 0x1p-24f};
}

float inUnit(float v) {
  return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f;
}  // NaN becomes 0

/// Triangular noise of +-1 code makes mean and variance of the error independent of the value; next to black
/// and white it would be cut off, so uniform noise takes over there. Both keep the mean exact.
std::uint8_t ditheredCode(float value, std::uint64_t index) {
  const float x = inUnit(value) * 255.0f;
  const Uniforms u = uniformsAt(index);
  const float noisy = x < 1.0f || x > 254.0f ? x + u.a : x + 0.5f + (u.a - u.b);
  return std::uint8_t(std::fmin(std::floor(noisy), 255.0f));
}

template <class Code, class Quantise>
std::vector<Code> quantised(const sdk::ImageRecord& image, Quantise&& quantise) {
  std::vector<Code> codes(std::size_t(image.width) * image.height * 3);
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = quantise(image.displayed[i], i);
  return codes;
}

void encode(const sdk::ImageRecord& image, OIIO::TypeDesc type, const void* codes, sdk::Writer& writer) {
  OIIO::ImageSpec spec(int(image.width), int(image.height), 3, type);
  for (std::uint64_t i = 0; i < image.metadataCount; ++i)
    spec.attribute(image.metadata[i].key.str(), image.metadata[i].value.str());
  spec.attribute("oiio:ColorSpace", "sRGB");  // becomes the sRGB chunk
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("png");
  if (!output || !output->set_ioproxy(&memory)) throw std::runtime_error("OpenImageIO here has no PNG");
  // The writer reports some failures only through has_error().
  if (!output->open("image.png", spec) || !output->write_image(type, codes) || !output->close() ||
      output->has_error())
    throw std::runtime_error(output->geterror());
  writer.write(bytes.data(), bytes.size());
}

class Png final : public sdk::Exporter {
 public:
  Png()
      : Exporter({.id = "org.steradian.png",
                  .name = "PNG",
                  .version = "1.0.0",
                  .extensions = ".png",
                  .takesImage = 1,
                  .parameterCount = 1,
                  .parameters = kParameters}) {}

  void exportImage(sdk::Host& host, const sdk::ImageRecord& image, sdk::Writer& writer) override {
    if (!image.displayed) throw std::logic_error("needs display-encoded pixels");
    const int bits = int(host.parameter("bitDepth"));
    if (bits == 8)
      encode(image, OIIO::TypeDesc::UINT8, quantised<std::uint8_t>(image, ditheredCode).data(), writer);
    else if (bits == 16)
      encode(image, OIIO::TypeDesc::UINT16,
             quantised<std::uint16_t>(
                 image, [](float v, std::size_t) { return std::uint16_t(std::lround(inUnit(v) * 65535.0f)); })
                 .data(),
             writer);
    else
      throw sdk::BadInput("bitDepth is " + std::to_string(bits) + "; expected 8 or 16");
  }
};

}  // namespace

STERADIAN_PLUGIN(registry) {
  registry.add<Png>();
}
