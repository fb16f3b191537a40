// SPDX-License-Identifier: MIT
// A compute pass that adds numbers, and a graphics pass that draws where it is told.
#include <gtest/gtest.h>

#include <bit>
#include <numeric>

#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/pass.hpp"
#include "renderer/scene/error.hpp"
#include "tests/renderer/gpu/render_target.hpp"

#include "add_comp.h"
#include "position_frag.h"
#include "quad_vert.h"

namespace steradian::gpu {
namespace {

std::shared_ptr<Device> open() {
  return openDevice({{}, true, nullptr});
}

class Adder : public testing::Test {
 protected:
  static constexpr std::uint32_t count = 1000;
  struct Push {
    float offset;
    std::uint32_t count;
  };
  std::shared_ptr<Device> device_ = open();
  Buffer rows_{*device_, BufferKind::upload, count * 16, "rows"};
  Buffer values_{*device_, BufferKind::upload, count * 4, "values"};
  Buffer sums_{*device_, BufferKind::deviceLocal, count * 4, "sums"};

  void SetUp() override {
    std::vector<float> rows(count * 4, -1e9f), values(count);
    for (std::uint32_t i = 0; i < count; ++i) rows[i * 4] = float(i);
    std::iota(values.begin(), values.end(), 100.0f);
    rows_.writeRows<float>(0, rows);
    values_.writeRows<float>(0, values);
    fillZero(*device_, sums_);
  }
  std::vector<float> sumsOf(std::span<const Specialization> constants, Push push) {
    const ComputePass pass(*device_, add_comp, constants, "add");
    const Buffer* const storage[] = {&values_, &sums_};
    const Bindings bindings(*device_, {&rows_}, storage);
    device_->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
      pass.dispatch(cmd, bindings, push, (count + 63) / 64, 1);
    });
    return downloadAs<float>(*device_, sums_, 0, count);
  }
};

TEST_F(Adder, TexelsStorageAndPushConstantsMeet) {
  const auto sums = sumsOf({}, {0.5f, count});
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(sums[i], 2.0f * float(i) + 100.5f);
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Adder, SpecializationConstantsGoByTheirIds) {
  const Specialization constants[] = {{3, VK_TRUE}, {0, 7}};
  const auto sums = sumsOf(constants, {0.0f, count - 1});
  for (std::uint32_t i = 0; i + 1 < count; ++i) ASSERT_EQ(sums[i], 2.0f * (2.0f * float(i) + 107.0f));
  EXPECT_EQ(sums.back(), 0.0f) << "beyond the pushed count";
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Adder, UnusedBindingsNeedNoBuffer) {
  const ComputePass pass(*device_, add_comp, {}, "add");
  const Bindings bindings(*device_, {}, {});
  device_->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
    pass.dispatch(cmd, bindings, Push{0.0f, 0}, 1, 1);
  });
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Adder, ABarrierOrdersTwoDispatches) {
  const ComputePass pass(*device_, add_comp, {}, "add");
  const Buffer* const once[] = {&values_, &sums_};
  const Buffer* const again[] = {&sums_, &values_};
  const Bindings first(*device_, {&rows_}, once), second(*device_, {&rows_}, again);
  device_->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
    pass.dispatch(cmd, first, Push{0.0f, count}, 16, 1);
    computeToCompute(cmd);
    pass.dispatch(cmd, second, Push{0.0f, count}, 16, 1);
  });
  const auto sums = downloadAs<float>(*device_, values_, 0, count);
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(sums[i], 3.0f * float(i) + 100.0f);
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Adder, WorkInFlightIsWaitedForAlsoWhenTheDeviceIsTakenForLost) {
  const ComputePass pass(*device_, add_comp, {}, "add");
  const Buffer* const storage[] = {&values_, &sums_};
  const Bindings bindings(*device_, {&rows_}, storage);
  {
    Commands commands(*device_, QueueKind::compute);
    commands.submit([&](const vk::raii::CommandBuffer& cmd) {
      for (int i = 0; i < 5000; ++i) {
        pass.dispatch(cmd, bindings, Push{float(i), count}, (count + 63) / 64, 1);
        computeToCompute(cmd);
      }
    });
    device_->markLost();
  }
  EXPECT_EQ(validationMessages(*device_), 0) << "freed while the device uses it";
}

class Picture : public testing::TestWithParam<Extent> {};

TEST_P(Picture, ShowsTheQuadInsideTheRectangleOnly) {
  const auto device = open();
  const Extent extent = GetParam();
  RenderTarget target(*device, extent);
  Buffer value(*device, BufferKind::deviceLocal, 256, "value");
  const Buffer* const storage[] = {&value};
  const Bindings bindings(*device, {}, storage);
  const GraphicsPass pass(*device, quad_vert, position_frag, target.renderPass(), {}, "position");
  device->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
    cmd.fillBuffer(value.handle(), 0, VK_WHOLE_SIZE, std::bit_cast<std::uint32_t>(1234.5f));
  });
  const std::uint32_t from = device->compute().family, to = device->graphics().family;
  const PixelRect rect{extent.width / 4, extent.height / 2, extent.width / 2, extent.height / 4};
  device->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) { release(cmd, value, from, to); });
  for (int frame = 0; frame < 2; ++frame) {
    const Image image =
        target.render([&](const vk::raii::CommandBuffer& cmd) { pass.draw(cmd, bindings, 2.0f, rect); },
                      [&](const vk::raii::CommandBuffer& cmd) {
                        if (frame == 0) acquire(cmd, value, from, to);
                      });
    ASSERT_EQ(image.width, extent.width);
    ASSERT_EQ(image.height, extent.height);
    ASSERT_EQ(image.channels, 3);
    for (int y = 0; y < extent.height; ++y)
      for (int x = 0; x < extent.width; ++x) {
        const bool inside = x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
        const float* pixel = image.at(x, y);
        ASSERT_EQ(pixel[0], inside ? 2.0f * (float(x) + 0.5f) : 0.0f) << x << "," << y;
        ASSERT_EQ(pixel[1], inside ? 2.0f * (float(y) + 0.5f) : 0.0f) << x << "," << y;
        ASSERT_EQ(pixel[2], inside ? 1234.5f : 0.0f) << x << "," << y;
      }
  }
  EXPECT_EQ(validationMessages(*device), 0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Picture, testing::Values(Extent{64, 48}, Extent{333, 127}, Extent{1, 1}));

TEST(RenderTargets, BeyondTheLimitAreRefused) {
  const auto device = open();
  EXPECT_THROW(RenderTarget(*device, Extent{1 << 24, 4}), Error);
  EXPECT_THROW(RenderTarget(*device, Extent{0, 4}), Error);
}

}  // namespace
}  // namespace steradian::gpu
