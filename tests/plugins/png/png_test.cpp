// SPDX-License-Identifier: MIT
// PNG files hold the right codes: exact at 16 bits, right on average at 8.
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "tests/measured.hpp"
#include "tests/plugins/fixture.hpp"

namespace steradian::plugins {
namespace {

class Png : public FolderTest {
 protected:
  template <class Code>
  std::vector<Code> codes(const std::vector<float>& pixels, int width, OIIO::TypeDesc type, double bits) {
    ImageToSave image{.width = width, .height = int(pixels.size()) / 3 / width, .displayed = pixels.data()};
    image.metadata = {{"Description", "a test"}};
    stockPlugins().exportImage(image, folder / "a.png", {}, {{"bitDepth", bits}});
    const auto input = OIIO::ImageInput::create("png");
    EXPECT_TRUE(input && input->open((folder / "a.png").string(), spec)) << OIIO::geterror();
    EXPECT_EQ(spec.format, type);
    std::vector<Code> out(pixels.size());
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, type, out.data())) << input->geterror();
    return out;
  }
  std::vector<std::uint8_t> codes8(const std::vector<float>& pixels, int width) {
    return codes<std::uint8_t>(pixels, width, OIIO::TypeDesc::UINT8, 8);
  }
  OIIO::ImageSpec spec;
};

const float kNaN = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

TEST_F(Png, SixteenBitsAreTheNearestCodes) {
  const auto read = codes<std::uint16_t>({0.0f, 0.5f, 1.0f, 0.25f, 1.0f / 65535, 0.9999f, -1.0f, kInf, kNaN},
                                         3, OIIO::TypeDesc::UINT16, 16);
  EXPECT_EQ(read, (std::vector<std::uint16_t>{0, 32768, 65535, 16384, 1, 65528, 0, 65535, 0}));
}

TEST_F(Png, row39_eight_bits_are_right_on_average_within_0_05_codes) {
  for (float code :
       {0.0f, 0.1f, 0.5f, 0.99f, 1.0f, 1.3f, 17.25f, 127.5f, 200.7f, 253.9f, 254.0f, 254.6f, 255.0f}) {
    const auto read = codes8(std::vector<float>(128 * 128 * 3, code / 255.0f), 128);
    const double mean = std::accumulate(read.begin(), read.end(), 0.0) / double(read.size());
    EXPECT_NEAR(mean, code, 0.05) << code;
    measured("error of the mean of a block, codes", std::abs(mean - double(code)), 0.05);
  }
}

TEST_F(Png, DitherHidesTheStepsOfARamp) {
  // A ramp over two codes in blocks of 64x64: undithered, a block's mean is off by up to half a code.
  double worst = 0;
  for (int step = 0; step < 16; ++step) {
    const float code = 100.0f + float(step) / 8.0f;
    const auto read = codes8(std::vector<float>(64 * 64 * 3, code / 255.0f), 64);
    worst = std::max(worst,
                     std::abs(std::accumulate(read.begin(), read.end(), 0.0) / double(read.size()) - code));
    for (int code8 : read) ASSERT_NEAR(code8, code, 1.5);
  }
  EXPECT_LT(worst, 0.05);
}

TEST_F(Png, BlackWhiteAndTheUndefinedStayClean) {
  const auto read = codes8({0.0f, 1.0f, kNaN, kInf, -kInf, 2.0f, -0.0f, 0.0f, 1.0f}, 3);
  EXPECT_EQ(read, (std::vector<std::uint8_t>{0, 255, 0, 255, 0, 255, 0, 0, 255}));
}

TEST_F(Png, SaysThatItIsSrgbAndKeepsTheText) {
  codes8({0, 0, 0}, 1);
  const std::string bytes = readText(folder / "a.png");
  EXPECT_CONTAINS(bytes, "sRGB");
  EXPECT_CONTAINS(bytes, "a test");
}

TEST_F(Png, TheSamePictureGivesTheSameBytes) {
  const std::vector<float> grey(300, 0.4f);
  codes8(grey, 10);
  const std::string first = readText(folder / "a.png");
  codes8(grey, 10);
  EXPECT_EQ(readText(folder / "a.png"), first);
}

TEST_F(Png, OtherBitDepthsAreRefused) {
  const float pixel[3] = {};
  const auto [message, code] = faultOf([&] {
    stockPlugins().exportImage({.width = 1, .height = 1, .displayed = pixel}, folder / "b.png", {},
                               {{"bitDepth", 12.0}});
  });
  EXPECT_EQ(code, ExitCode::badInput);
  EXPECT_CONTAINS(message, "bitDepth is 12; expected 8 or 16");
}

}  // namespace
}  // namespace steradian::plugins
