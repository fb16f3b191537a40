// SPDX-License-Identifier: MIT
// Lookups of textures of every format, size, wrapping and level against double precision, written from the
// definitions: texel centres at halves, (0, 0) top left, IEC 61966-2-1, box-filtered mip levels.
#include <cmath>

#include "renderer/gpu_textures.hpp"
#include "shaders/kernel_texture.comp.h"
#include "tests/renderer/textures.hpp"
#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {
namespace {

using namespace textures;
using Image = std::vector<glm::dvec4>;

const Kernel lookups{kernel_texture_spirv, "texture"};

class TextureLookup : public KernelTest {};

double stored(double value, Format format) {
  if (format == Format::rgbaHalf) return glm::unpackHalf1x16(glm::packHalf1x16(float(value)));
  const double most = format == Format::rgba8 ? 255.0 : 65535.0;
  return std::round(value * most) / most;
}
double decoded(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}
double encoded(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// What the texture means, with its levels.
struct Truth {
  int width, height;
  std::vector<Image> levels;  // linear

  glm::dvec4 at(int level, int x, int y) const {
    return levels[std::size_t(level)][std::size_t(y) * std::size_t(sizeOf(width, level)) + std::size_t(x)];
  }
  static int sizeOf(int size, int level) { return std::max(size >> level, 1); }
};

glm::dvec4 value(int x, int y) {
  const auto part = [&](int a, int b) { return double((x * a + y * b) % 17) / 16.0; };
  return {part(5, 3), part(7, 11), part(2, 9), part(3, 8)};
}

// One level from the one before, every share computed by overlapping intervals.
Image below(const Image& above, int width, int height) {
  const int w = std::max(width / 2, 1), h = std::max(height / 2, 1);
  Image made;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      glm::dvec4 sum(0.0);
      for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
          const auto overlap = [](double n, double source, int at, int from) {
            const double scale = source / n;
            return std::max(0.0,
                            std::min((at + 1) * scale, from + 1.0) - std::max(at * scale, double(from))) /
                   scale;
          };
          sum += overlap(w, width, x, i) * overlap(h, height, y, j) * above[std::size_t(j * width + i)];
        }
      made.push_back(sum);
    }
  return made;
}

Truth truthOf(int width, int height, Format format, bool srgb) {
  Truth truth{width, height, {{}}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      glm::dvec4 texel = value(x, y);
      for (int c = 0; c < 4; ++c) texel[c] = stored(texel[c], format);
      if (srgb && format != Format::rgbaHalf)
        for (int c = 0; c < 3; ++c) texel[c] = decoded(texel[c]);
      truth.levels[0].push_back(texel);
    }
  for (int level = 0; (std::max(width, height) >> level) > 1; ++level)
    truth.levels.push_back(
        below(truth.levels.back(), Truth::sizeOf(width, level), Truth::sizeOf(height, level)));
  return truth;
}

int wrappedIndex(int i, int n, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(i, 0, n - 1);
  const int period = wrap == Wrap::mirror ? 2 * n : n;
  const int folded = ((i % period) + period) % period;
  return folded < n ? folded : 2 * n - 1 - folded;
}

glm::dvec4 lookedUp(const Truth& truth, const TextureSlot& slot, double u, double v, int level) {
  const int w = Truth::sizeOf(truth.width, level), h = Truth::sizeOf(truth.height, level);
  const auto texel = [&](double x, double y) {
    return truth.at(level, wrappedIndex(int(x), w, slot.wrapU), wrappedIndex(int(y), h, slot.wrapV));
  };
  if (slot.nearest) return texel(std::floor(u * w), std::floor(v * h));
  const double x = u * w - 0.5, y = v * h - 0.5, left = std::floor(x), top = std::floor(y);
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                  glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

/// One material whose only texture is the slot's.
struct OnDevice {
  Task task;
  std::uint32_t row = 0;
};
OnDevice uploaded(const TextureSlot& slot, bool srgb) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].id = Id{1};
  (srgb ? scene.materials[0].albedoTexture : scene.materials[0].normalTexture) = slot;
  TextureCache cache;
  TexturePlaces places(scene, cache);
  OnDevice made;
  made.task.scene.resize(1);  // row 0 means none
  const TextureRefs refs = places.refs(scene.materials[0], made.task.scene);
  made.row = srgb ? refs.x : refs.z;
  made.task.texels = texelTables(places.all());
  for (const auto& texture : places.all())
    made.task.texels.insert(made.task.texels.end(), texture->words.begin(), texture->words.end());
  return made;
}

// Not near the border between two texels, where float may choose the other one.
bool clear(double u, int size) {
  const double x = u * size;
  return std::abs(x - std::round(x)) > 1e-3;
}

TEST_F(TextureLookup, every_format_size_and_wrapping_gives_what_double_precision_gives) {
  Random random(7);
  double worst = 0.0;
  for (const Format format : {Format::rgba8, Format::rgba16, Format::rgbaHalf})
    for (const bool srgb : {false, true})
      for (const auto [width, height] : {std::pair(1, 1), {7, 5}, {16, 4}, {1, 9}})
        for (int i = 0; i < 6; ++i) {
          TextureSlot slot = textures::slot(
              made(width, height, format, [](int x, int y) { return glm::vec4(value(x, y)); }), i >= 3);
          slot.wrapU = Wrap(i % 3);
          slot.wrapV = Wrap((i + 1) % 3);
          const Truth truth = truthOf(width, height, format, srgb);
          const OnDevice device = uploaded(slot, srgb);
          Rows questions;
          for (int k = 0; k < 64; ++k)
            questions.emplace_back(random.uniform(-2.5, 3.5), random.uniform(-2.5, 3.5), 0.0f,
                                   float(device.row));
          const Rows answers = run(lookups, device.task, questions);
          for (std::size_t k = 0; k < questions.size(); ++k) {
            const double u = questions[k].x, v = questions[k].y;
            if (slot.nearest && !(clear(u, width) && clear(v, height))) continue;
            const double error = glm::length(glm::dvec4(answers[k]) - lookedUp(truth, slot, u, v, 0));
            worst = std::max(worst, error);
            EXPECT_LT(error, 2e-5) << int(format) << srgb << " " << width << "x" << height << " " << i << " "
                                   << u << " " << v;
          }
        }
  RecordProperty("worst", std::to_string(worst));
}

TEST_F(TextureLookup, every_level_is_the_average_of_the_one_before) {
  for (const Format format : {Format::rgba8, Format::rgba16, Format::rgbaHalf})
    for (const bool srgb : {false, true})
      for (const auto [width, height] : {std::pair(16, 16), {13, 6}, {1, 9}}) {
        TextureSlot slot =
            textures::slot(made(width, height, format, [](int x, int y) { return glm::vec4(value(x, y)); }));
        const Truth truth = truthOf(width, height, format, srgb);
        const OnDevice device = uploaded(slot, srgb);
        for (int level = 1; level < int(truth.levels.size()); ++level) {
          const int w = Truth::sizeOf(width, level), h = Truth::sizeOf(height, level);
          Rows questions;
          for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
              questions.emplace_back((x + 0.5f) / float(w), (y + 0.5f) / float(h), float(level),
                                     float(device.row));
          const Rows answers = run(lookups, device.task, questions);
          // Half a code of the format, where sRGB counts.
          const bool codes = srgb && format != Format::rgbaHalf;
          const double gate =
              format == Format::rgba8 ? 0.51 / 255.0 : (format == Format::rgba16 ? 0.51 / 65535.0 : 5e-4);
          for (int i = 0; i < w * h; ++i)
            for (int c = 0; c < 4; ++c) {
              const double exact = truth.at(level, i % w, i / w)[c], seen = answers[std::size_t(i)][c];
              const bool code = codes && c < 3;
              EXPECT_NEAR(code ? encoded(seen) : seen, code ? encoded(exact) : exact, gate)
                  << level << " " << i << " " << c;
            }
        }
      }
}

TEST_F(TextureLookup, the_level_follows_the_footprint_and_jitter_blends_two_of_them) {
  const OnDevice device =
      uploaded(textures::slot(made(64, 64, Format::rgba8, [](int, int) { return glm::vec4(0.5f); })), false);
  Task task = device.task;
  task.operation = 1;
  Rows questions;
  Random random(3);
  const double texels[] = {0.01, 1.0, 2.0, 4.0, 6.0, 64.0, 1e6};
  for (const double n : texels)
    for (int i = 0; i < 1000; ++i)
      questions.emplace_back(n / 64.0 / 3.0, 3.0f, random.uniform(), float(device.row));
  const Rows answers = run(lookups, task, questions);
  for (std::size_t k = 0; k < std::size(texels); ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 1000; ++i) sum += answers[k * 1000 + i].x;
    EXPECT_NEAR(sum / 1000.0, std::clamp(std::log2(texels[k]), 0.0, 6.0), 0.05) << texels[k];
  }
}

TEST(Textures, one_that_two_materials_share_is_kept_once_and_made_once) {
  const TextureSlot shared =
      textures::slot(made(8, 8, Format::rgba8, [](int x, int y) { return glm::vec4(value(x, y)); }));
  Scene scene;
  for (unsigned i = 1; i <= 2; ++i) {
    Material m;
    m.id = Id{i};
    m.albedoTexture = m.emissionTexture = shared;
    scene.materials.push_back(m);
  }
  TextureCache cache;
  const auto first = TexturePlaces(scene, cache).all();
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0]->words.size(), 4u + 64 + 16 + 4 + 1);
  scene.materials.pop_back();
  EXPECT_EQ(TexturePlaces(scene, cache).all(), first);
  scene.materials[0].normalTexture = shared;  // linear codes give other levels
  EXPECT_EQ(TexturePlaces(scene, cache).all().size(), 2u);
}

TEST(Textures, one_that_is_not_decoded_or_not_whole_counts_as_none) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].albedoTexture.texture = std::make_shared<Texture>();
  auto half = std::make_shared<Texture>(*made(8, 8, Format::rgba8, [](int, int) { return glm::vec4(1.0f); }));
  half->pixels.bytes.resize(100);
  scene.materials[0].normalTexture.texture = half;
  TextureCache cache;
  TexturePlaces places(scene, cache);
  std::vector<glm::vec4> rows;
  EXPECT_EQ(places.refs(scene.materials[0], rows), TextureRefs(0));
  EXPECT_TRUE(places.all().empty() && rows.empty());
}

}  // namespace
}  // namespace steradian::kernel
