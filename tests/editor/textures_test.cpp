// SPDX-License-Identifier: MIT
// Textures come to the renderer as their files hold them, once, and what is no texture is named and left out.
#include "editor/textures.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include "editor/assets.hpp"
#include "editor/image_file.hpp"
#include "renderer/scene/error.hpp"
#include "tests/temporary_folder.hpp"

namespace steradian {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using Format = TexturePixels::Format;

template <class Value>
Bytes encoded(const std::string& format, int width, int height, int channels,
              const std::vector<Value>& pixels) {
  Bytes out;
  OIIO::Filesystem::IOVecOutput memory(out);
  const auto writer = OIIO::ImageOutput::create(format);
  OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<Value>::value);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (format == "openexr") spec.attribute("compression", "zip");
  EXPECT_TRUE(writer->set_ioproxy(&memory));
  EXPECT_TRUE(writer->open("x." + format, spec)) << writer->geterror();
  EXPECT_TRUE(writer->write_image(spec.format, pixels.data())) << writer->geterror();
  writer->close();
  return out;
}

Bytes bytePng(int channels, const std::vector<std::uint8_t>& pixels) {
  return encoded("png", int(pixels.size()) / channels, 1, channels, pixels);
}

float halfAt(const TexturePixels& pixels, std::size_t index) {
  std::uint16_t bits;
  std::memcpy(&bits, &pixels.bytes[2 * index], 2);
  const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
  return exponent ? std::ldexp(1024.0f + float(mantissa), exponent - 25) : std::ldexp(float(mantissa), -24);
}

std::string refusal(const Bytes& bytes) {
  try {
    decodeTexture(bytes);
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::badInput);
    return error.what();
  }
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE(std::string(text).find(part), std::string::npos) << (text)

TEST(DecodeTexture, eight_bits_stay_as_they_are_and_grey_becomes_rgb) {
  EXPECT_EQ(decodeTexture(bytePng(4, {1, 2, 3, 4, 250, 251, 252, 0})).bytes,
            (Bytes{1, 2, 3, 4, 250, 251, 252, 0}));
  EXPECT_EQ(decodeTexture(bytePng(3, {1, 2, 3})).bytes, (Bytes{1, 2, 3, 255}));
  EXPECT_EQ(decodeTexture(bytePng(2, {9, 7})).bytes, (Bytes{9, 9, 9, 7}));
  const TexturePixels grey = decodeTexture(bytePng(1, {9, 8}));
  EXPECT_EQ(grey.bytes, (Bytes{9, 9, 9, 255, 8, 8, 8, 255}));
  EXPECT_EQ(grey.format, Format::rgba8);
  EXPECT_EQ(grey.width, 2);
  EXPECT_EQ(grey.height, 1);
}

TEST(DecodeTexture, sixteen_bits_stay_as_they_are) {
  const TexturePixels p = decodeTexture(encoded<std::uint16_t>("png", 1, 2, 3, {1, 256, 65535, 7, 8, 9}));
  EXPECT_EQ(p.format, Format::rgba16);
  std::uint16_t values[8];
  ASSERT_EQ(p.bytes.size(), sizeof values);
  std::memcpy(values, p.bytes.data(), sizeof values);
  EXPECT_EQ(std::vector<std::uint16_t>(values, values + 8),
            (std::vector<std::uint16_t>{1, 256, 65535, 65535, 7, 8, 9, 65535}));
}

TEST(DecodeTexture, floats_become_finite_halves_that_are_not_negative) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  const TexturePixels p = decodeTexture(encoded<float>(
      "openexr", 2, 1, 3, {0.5f, -1.0f, inf, std::numeric_limits<float>::quiet_NaN(), 1e6f, 2.0f}));
  EXPECT_EQ(p.format, Format::rgbaHalf);
  const float expected[] = {0.5f, 0, 65504, 1, 0, 65504, 2, 1};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(halfAt(p, i), expected[i]) << i;
}

TEST(DecodeTexture, a_jpeg_and_a_radiance_file_are_read) {
  const TexturePixels jpeg = decodeTexture(encoded<std::uint8_t>("jpeg", 16, 16, 3, Bytes(16 * 16 * 3, 128)));
  EXPECT_EQ(jpeg.format, Format::rgba8);
  EXPECT_EQ(jpeg.bytes.size(), 16u * 16 * 4);
  EXPECT_NEAR(jpeg.bytes[0], 128, 2);
  const TexturePixels hdr = decodeTexture(encoded<float>("hdr", 8, 1, 3, std::vector<float>(24, 4.0f)));
  EXPECT_EQ(hdr.format, Format::rgbaHalf);
  EXPECT_EQ(halfAt(hdr, 0), 4.0f);
}

TEST(DecodeTexture, only_the_first_bytes_decide_and_what_is_damaged_says_so) {
  EXPECT_CONTAINS(refusal({}), "is not a PNG, JPEG, HDR or EXR image");
  EXPECT_CONTAINS(refusal({'B', 'M', 0, 0, 0, 0, 0, 0}), "is not a PNG");
  for (const char* format : {"png", "jpeg", "openexr", "hdr"}) {
    Bytes bytes = format == std::string("png") || format == std::string("jpeg")
                      ? encoded<std::uint8_t>(format, 32, 32, 3, Bytes(3072, 77))
                      : encoded<float>(format, 32, 32, 3, std::vector<float>(3072, 0.7f));
    bytes.resize(16);
    EXPECT_CONTAINS(refusal(bytes), "is damaged or not readable: ") << format;
  }
}

TEST(DecodeTexture, fault12_damaged_files_are_refused_or_shown_and_never_end_the_program) {
  std::mt19937 random(7);
  const Bytes noise = [&] {
    Bytes out(64 * 64 * 3);
    for (auto& each : out) each = std::uint8_t(random());
    return out;
  }();
  const std::vector<float> floats(noise.begin(), noise.end());
  const Bytes files[] = {encoded("png", 64, 64, 3, noise), encoded("jpeg", 64, 64, 3, noise),
                         encoded("openexr", 64, 64, 3, floats), encoded("hdr", 64, 64, 3, floats)};
  int shown = 0, refused = 0;
  for (int round = 0; round < 250; ++round)
    for (Bytes bytes : files) {
      // The head is where sizes and offsets lie.
      for (int i = 0; i < 3; ++i)
        bytes[8 + random() % (round % 2 ? bytes.size() - 8 : 300)] = std::uint8_t(random());
      if (round % 5 == 0) bytes.resize(random() % bytes.size());
      try {
        const TexturePixels pixels = decodeTexture(bytes);
        EXPECT_EQ(pixels.bytes.size(),
                  std::size_t(pixels.width) * pixels.height * (pixels.format == Format::rgba8 ? 4 : 8));
        ++shown;
      } catch (const Error&) {
        ++refused;
      }
    }
  EXPECT_GT(shown, 100);
  EXPECT_GT(refused, 100);
}

/// Most memory that the process ever had, in MiB.
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

TEST(DecodeTexture, fault11_a_decompression_bomb_is_refused_before_memory_is_taken) {
  decodeTexture(bytePng(1, {1}));  // loads the library
  const double before = peakMemory();
  Bytes bomb = bytePng(1, {0});
  const std::uint8_t size[] = {0, 0, 0x40, 0, 0, 0, 0x20, 0};  // 16384 x 8192
  std::memcpy(&bomb[16], size, sizeof size);
  const std::uint32_t table = [&] {  // the header's CRC-32, so that it is the size that is refused
    std::uint32_t crc = ~0u;
    for (std::size_t i = 12; i < 29; ++i) {
      crc ^= bomb[i];
      for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
  }();
  for (int i = 0; i < 4; ++i) bomb[29 + i] = std::uint8_t(table >> (24 - 8 * i));
  EXPECT_CONTAINS(refusal(bomb), "taken for an attack");
  Bytes exr = encoded<float>("openexr", 1, 1, 3, {1, 1, 1});
  const std::string name("dataWindow\0box2i\0", 17);
  const auto at = std::search(exr.begin(), exr.end(), name.begin(), name.end());
  ASSERT_NE(at, exr.end());
  const std::int32_t million = 999'999;
  std::memcpy(&*at + 17 + 4 + 8, &million, 4);
  std::memcpy(&*at + 17 + 4 + 12, &million, 4);
  EXPECT_CONTAINS(refusal(exr), "is damaged or not readable: ");
  EXPECT_LT(peakMemory() - before, 64);
}

class TexturesTest : public TemporaryFolder {
 protected:
  static Scene sceneWith(const std::vector<Texture>& textures) {
    Scene scene;
    for (const Texture& texture : textures)
      scene.materials.push_back({.id = Id{unsigned(scene.materials.size()) + 1},
                                 .albedoTexture = {.texture = std::make_shared<const Texture>(texture)}});
    scene.nextId = Id{unsigned(textures.size()) + 1};
    return scene;
  }
  void write(const std::string& name, const Bytes& bytes) const {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  }
  static const std::shared_ptr<const Texture>& textureOf(const Scene& scene, std::size_t material) {
    return scene.materials[material].albedoTexture.texture;
  }
};

TEST_F(TexturesTest, every_slot_of_one_texture_gets_the_same_pixels) {
  Scene scene = sceneWith({{.name = "a", .encoded = bytePng(3, {1, 2, 3})}});
  scene.materials[0].normalTexture = scene.materials[0].albedoTexture;
  scene.materials[0].emissionTexture = scene.materials[0].albedoTexture;
  EXPECT_TRUE(Textures().load(scene, folder).empty());
  EXPECT_EQ(textureOf(scene, 0)->pixels.bytes, (Bytes{1, 2, 3, 255}));
  EXPECT_EQ(textureOf(scene, 0)->encoded, bytePng(3, {1, 2, 3}));
  EXPECT_EQ(scene.materials[0].normalTexture.texture, textureOf(scene, 0));
  EXPECT_EQ(scene.materials[0].emissionTexture.texture, textureOf(scene, 0));
}

TEST_F(TexturesTest, equal_textures_share_one_and_keep_it_while_a_scene_holds_it) {
  const Texture wood{.name = "wood", .encoded = bytePng(1, {5})},
      other{.name = "other", .encoded = bytePng(1, {5})};
  Textures textures;
  Scene first = sceneWith({wood, wood, other}), again = sceneWith({wood});
  EXPECT_TRUE(textures.load(first, folder).empty());
  EXPECT_TRUE(textures.load(again, folder).empty());
  EXPECT_EQ(textureOf(first, 0), textureOf(first, 1));
  EXPECT_EQ(textureOf(again, 0), textureOf(first, 0));
  EXPECT_EQ(textureOf(first, 2)->name, "other");
  EXPECT_EQ(textureOf(first, 2)->pixels.bytes, textureOf(first, 0)->pixels.bytes);
}

TEST_F(TexturesTest, a_file_beside_the_project_is_read_and_only_named) {
  write("wood.png", bytePng(1, {5}));
  Scene scene = sceneWith({{.name = "wood", .file = "wood.png"}});
  EXPECT_TRUE(Textures().load(scene, folder).empty());
  EXPECT_EQ(textureOf(scene, 0)->pixels.width, 1);
  EXPECT_TRUE(textureOf(scene, 0)->encoded.empty());
  const Scene moved = withAssetsNamedFrom(scene, folder, folder.parent_path());
  EXPECT_EQ(textureOf(moved, 0)->file, (folder.filename() / "wood.png").string());
  EXPECT_EQ(textureOf(moved, 0)->pixels.width, 1);
}

TEST_F(TexturesTest, fault10_what_is_missing_or_damaged_is_named_once_and_the_rest_is_shown) {
  Bytes cut = bytePng(3, Bytes(300, 7));
  cut.resize(cut.size() / 2);
  write("cut.png", cut);
  write("empty.png", {});
  fs::create_directory(folder / "folder.png");
  Scene scene = sceneWith({{.name = "lost", .file = "lost.png"},
                           {.name = "cut", .file = "cut.png"},
                           {.name = "empty", .file = "empty.png"},
                           {.name = "folder", .file = "folder.png"},
                           {.name = "good", .encoded = bytePng(1, {5})}});
  scene.materials[0].normalTexture = scene.materials[0].albedoTexture;
  const std::vector<std::string> messages = Textures().load(scene, folder);
  ASSERT_EQ(messages.size(), 4u);
  const char* parts[][2] = {{"lost.png", "No such file"},
                            {"cut.png", "is damaged"},
                            {"empty.png", "is not a PNG"},
                            {"folder.png", "is a folder"}};
  for (std::size_t i = 0; i < 4; ++i) {
    for (const char* part : parts[i]) EXPECT_CONTAINS(messages[i], part);
    EXPECT_CONTAINS(messages[i], "; what uses it is shown without it");
    EXPECT_EQ(textureOf(scene, i)->pixels.width, 0);
  }
  EXPECT_EQ(textureOf(scene, 4)->pixels.width, 1);
  EXPECT_EQ(loadAssets(scene, folder).size(), 4u) << "commands warn and go on";
}

}  // namespace
}  // namespace steradian
