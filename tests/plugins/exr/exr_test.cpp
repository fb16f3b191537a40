// SPDX-License-Identifier: MIT
// EXR files read back bit for bit, with their colour space and metadata.
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "tests/measured.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

class Exr : public FolderTest {
 protected:
  struct Read {
    OIIO::ImageSpec spec;
    std::vector<float> pixels;
  };
  Read saved(const std::vector<float>& pixels, int width, const Parameters& parameters = {}) {
    ImageToSave image{.width = width, .height = int(pixels.size()) / 3 / width, .radiance = pixels.data()};
    image.metadata = {{"samplesPerPixel", "64"}, {"Software", "Steradian test"}};
    const fs::path file = folder / "a.exr";
    stockPlugins().exportImage(image, file, {}, parameters);
    const auto input = OIIO::ImageInput::create("openexr");
    Read out;
    EXPECT_TRUE(input && input->open(file.string(), out.spec)) << OIIO::geterror();
    out.pixels.resize(pixels.size());
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, out.pixels.data())) << input->geterror();
    return out;
  }
};

TEST_F(Exr, row39_floats_come_back_bit_for_bit) {
  std::mt19937 random(3);
  std::vector<float> pixels(37 * 131 * 3);  // not a multiple of the rows written at once
  for (float& v : pixels) {
    const std::uint32_t bits = random();
    std::memcpy(&v, &bits, 4);  // every pattern: denormals, infinities, NaN
  }
  const Read read = saved(pixels, 37);
  EXPECT_EQ(read.spec.width, 37);
  EXPECT_EQ(read.spec.height, 131);
  EXPECT_EQ(read.spec.nchannels, 3);
  EXPECT_EQ(read.spec.format, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(std::memcmp(read.pixels.data(), pixels.data(), pixels.size() * 4), 0);
  measured("files that differ", std::memcmp(read.pixels.data(), pixels.data(), pixels.size() * 4) != 0, 0);
}

TEST_F(Exr, CarriesRec709ZipAndMetadata) {
  const Read read = saved({1, 2, 3}, 1);
  EXPECT_EQ(read.spec.get_string_attribute("compression"), "zip");
  EXPECT_EQ(read.spec.get_string_attribute("samplesPerPixel"), "64");
  EXPECT_EQ(read.spec.get_string_attribute("Software"), "Steradian test");
  float chromaticities[8] = {};
  ASSERT_TRUE(
      read.spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities));
  const float rec709[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(chromaticities[i], rec709[i]);
}

TEST_F(Exr, row39_half_is_bounded_instead_of_becoming_infinite) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Read read = saved({infinity, 65520.0f, -infinity, 0.1f, 1.0f, 65504.0f}, 2, {{"half", 1.0}});
  EXPECT_EQ(read.spec.format, OIIO::TypeDesc::HALF);
  EXPECT_EQ(read.pixels[0], 65504.0f);
  EXPECT_EQ(read.pixels[1], 65504.0f);
  EXPECT_EQ(read.pixels[2], -65504.0f);
  EXPECT_NEAR(read.pixels[3], 0.1f, 0.1f * 4.9e-4f);
  measured("infinity as a half, beside 65504", std::abs(double(read.pixels[0]) - 65504.0), 0);
  measured("relative error of 0.1 as a half", std::abs(double(read.pixels[3]) / 0.1 - 1.0), 4.9e-4);
  EXPECT_EQ(read.pixels[4], 1.0f);
  EXPECT_EQ(read.pixels[5], 65504.0f);
}

TEST_F(Exr, TheSamePictureGivesTheSameBytesAtAnyTime) {
  const std::vector<float> pixels(30, 0.25f);
  saved(pixels, 5);
  const std::string first = readText(folder / "a.exr");
  saved(pixels, 5);
  EXPECT_EQ(readText(folder / "a.exr"), first);
  // A date would show in the bytes: every year from 2020 on begins so.
  EXPECT_EQ(first.find("202"), std::string::npos);
}

ImageLayer layerOf(const char* name, std::vector<std::string> channels, int width,
                   std::vector<float> pixels) {
  ImageLayer layer;
  layer.name = name;
  layer.pixels = {width, 1, int(channels.size()), std::move(pixels)};
  layer.channelNames = std::move(channels);
  return layer;
}

TEST_F(Exr, LayersComeBackBitForBitBesideThePicture) {
  const std::vector<float> radiance{1, 2, 3, 4, 5, 70000};
  std::vector<ImageLayer> layers;
  layers.push_back(layerOf("albedo", {"R", "G", "B"}, 2, {.1f, .2f, .3f, .4f, .5f, 70001}));
  layers.push_back(layerOf("depth", {"Z"}, 2, {1e30f, 16777215.0f}));
  for (const double half : {0.0, 1.0}) {
    ImageToSave image{.width = 2, .height = 1, .radiance = radiance.data()};
    image.layers = layers;
    const fs::path file = folder / "layers.exr";
    stockPlugins().exportImage(image, file, {}, {{"half", half}});
    const auto input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec spec;
    ASSERT_TRUE(input && input->open(file.string(), spec)) << OIIO::geterror();
    ASSERT_EQ(spec.channelnames,
              (std::vector<std::string>{"R", "G", "B", "albedo.R", "albedo.G", "albedo.B", "depth.Z"}));
    EXPECT_EQ(spec.channelformat(0), half != 0.0 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(spec.channelformat(6), OIIO::TypeDesc::FLOAT);
    std::vector<float> pixels(14);
    ASSERT_TRUE(input->read_image(0, 0, 0, 7, OIIO::TypeDesc::FLOAT, pixels.data())) << input->geterror();
    const float blue = half != 0.0 ? 65504.0f : 70000.0f;
    EXPECT_EQ(pixels,
              (std::vector<float>{1, 2, 3, .1f, .2f, .3f, 1e30f, 4, 5, blue, .4f, .5f, 70001, 16777215.0f}));
  }
}

TEST_F(Exr, ALayerOfAnotherSizeIsRefused) {
  const std::vector<float> radiance(6);
  const std::vector<ImageLayer> layers(1, layerOf("depth", {"Z"}, 1, {1}));
  ImageToSave image{.width = 2, .height = 1, .radiance = radiance.data()};
  image.layers = layers;
  const auto [message, code] = faultOf([&] { stockPlugins().exportImage(image, folder / "a.exr"); });
  EXPECT_EQ(code, ExitCode::badInput);
  EXPECT_CONTAINS(message, "the layer depth does not fit the picture");
}

TEST_F(Exr, AnEmptyImageAndMissingPixelsAreRefused) {
  EXPECT_EQ(faultOf([&] { stockPlugins().exportImage({}, folder / "a.exr"); }).second, ExitCode::badInput);
  const auto [message, code] =
      faultOf([&] { stockPlugins().exportImage({.width = 1, .height = 1}, folder / "a.exr"); });
  EXPECT_EQ(code, ExitCode::plugin);
  EXPECT_CONTAINS(message, "org.steradian.exr 1.0.0 failed: needs scene-linear pixels");
}

}  // namespace
}  // namespace steradian::plugins
