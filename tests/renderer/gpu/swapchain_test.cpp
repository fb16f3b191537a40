// SPDX-License-Identifier: MIT
// A window: draw, resize, present modes, screenshot. Skipped without a display.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <array>

#include "renderer/gpu/pass.hpp"
#include "renderer/gpu/swapchain.hpp"
#include "renderer/scene/error.hpp"

#include "position_frag.h"
#include "quad_vert.h"

extern "C" int glfwCreateWindowSurface(VkInstance, GLFWwindow*, const VkAllocationCallbacks*, VkSurfaceKHR*);

namespace steradian::gpu {
namespace {

class Window : public testing::Test {
 protected:
  void SetUp() override {
    if (!glfwInit()) GTEST_SKIP() << "no display";
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window_ = glfwCreateWindow(320, 200, "swapchain test", nullptr, nullptr);
    ASSERT_TRUE(window_);
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    source_.instanceExtensions.assign(names, names + count);
    source_.create = [this](void* instance) {
      VkSurfaceKHR surface = VK_NULL_HANDLE;
      glfwCreateWindowSurface(static_cast<VkInstance>(instance), window_, nullptr, &surface);
      return reinterpret_cast<std::uint64_t>(surface);
    };
    device_ = openDevice({{}, true, &source_});
  }
  void TearDown() override {
    device_.reset();
    if (window_) glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Extent framebuffer() const {
    glfwPollEvents();
    Extent extent;
    glfwGetFramebufferSize(window_, &extent.width, &extent.height);
    return extent;
  }

  GLFWwindow* window_ = nullptr;
  SurfaceSource source_;
  std::shared_ptr<Device> device_;
};

TEST_F(Window, ShowsWhatIsDrawnAndGreyElsewhere) {
  Swapchain swapchain(*device_, framebuffer(), PresentMode::fifo);
  EXPECT_THROW(swapchain.screenshot(), Error);
  Buffer value(*device_, BufferKind::upload, 256, "value");
  value.writeRows<float>(0, std::array{1.0f});
  const Buffer* const storage[] = {&value};
  const Bindings bindings(*device_, {}, storage);
  const GraphicsPass pass(*device_, quad_vert, position_frag, swapchain.renderPass(), {}, "position");
  for (int i = 0; i < 5; ++i) {
    const auto frame = swapchain.begin(framebuffer());
    ASSERT_TRUE(frame);
    swapchain.beginRenderPass(*frame);
    pass.draw(frame->cmd, bindings, 1.0f / 512.0f, {100, 50, 200, 100});
    swapchain.endRenderPass(*frame);
    swapchain.end(*frame);
  }
  Image image = swapchain.screenshot();
  ASSERT_EQ(image.width, 320);
  ASSERT_EQ(image.height, 200);
  EXPECT_NEAR(image.at(150, 100)[0], 150.5f / 512.0f, 1.0f / 255.0f);
  EXPECT_NEAR(image.at(150, 100)[1], 100.5f / 512.0f, 1.0f / 255.0f);
  EXPECT_EQ(image.at(150, 100)[2], 1.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(99, 100)[c], 0.1f, 0.5f / 255.0f);
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Window, SurvivesAStormOfResizesAndModes) {
  Swapchain swapchain(*device_, framebuffer(), PresentMode::mailbox);
  const VkRenderPass before = swapchain.renderPass();
  const std::vector<PresentMode> modes = swapchain.availableModes();
  int shown = 0;
  for (int i = 0; i < 60; ++i) {
    if (i % 3 == 0) glfwSetWindowSize(window_, 40 + 37 * (i % 17), 30 + 23 * (i % 13));
    if (i % 20 == 10) swapchain.setMode(modes[std::size_t(i / 20) % modes.size()]);
    const auto frame = swapchain.begin(framebuffer());
    if (!frame) continue;
    swapchain.beginRenderPass(*frame);
    swapchain.endRenderPass(*frame);
    swapchain.end(*frame);
    ++shown;
  }
  EXPECT_GT(shown, 50);
  EXPECT_EQ(VkRenderPass(swapchain.renderPass()), before);
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Window, AMinimisedOneIsSkippedAndComesBack) {
  Swapchain swapchain(*device_, framebuffer(), PresentMode::fifo);
  EXPECT_FALSE(swapchain.begin({0, 0}));
  const auto frame = swapchain.begin(framebuffer());
  ASSERT_TRUE(frame);
  swapchain.beginRenderPass(*frame);
  swapchain.endRenderPass(*frame);
  swapchain.end(*frame);
  EXPECT_EQ(validationMessages(*device_), 0);
}

TEST_F(Window, AFrameThatAnExceptionCutShortIsBegunAgain) {
  Swapchain swapchain(*device_, framebuffer(), PresentMode::fifo);
  for (int i = 0; i < 8; ++i) {
    const auto frame = swapchain.begin(i == 5 ? Extent{321, 201} : framebuffer());
    ASSERT_TRUE(frame);
    if (i % 2 == 0) continue;
    swapchain.beginRenderPass(*frame);
    swapchain.endRenderPass(*frame);
    swapchain.end(*frame);
  }
  EXPECT_EQ(validationMessages(*device_), 0);
}

}  // namespace
}  // namespace steradian::gpu
