// SPDX-License-Identifier: MIT
// The ImGui backends of GLFW and Vulkan, fed with the Presenter's handles.
#include "editor/ui/imgui_vulkan.hpp"

#include <vulkan/vulkan.h>
// GLFW declares its surface function only after vulkan.h.
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <string>

#include "editor/ui/style.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::ui {

namespace {

constexpr std::uint64_t kUploadTimeoutNs = 10'000'000'000;

void require(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  throw Error(ExitCode::noDevice, std::string("The device refused to make the user interface's ") + what +
                                      " (VkResult " + std::to_string(int(result)) +
                                      "). Restart Steradian; if it repeats, update the Vulkan driver.");
}

}  // namespace

SurfaceSource makeSurface(const Window& window) {
  GLFWwindow* handle = window.handle();
  return {window.vulkanExtensions(), [handle](void* instance) {
            VkSurfaceKHR surface = VK_NULL_HANDLE;
            require(glfwCreateWindowSurface(static_cast<VkInstance>(instance), handle, nullptr, &surface),
                    "window surface");
            return std::uint64_t(surface);
          }};
}

struct ImguiVulkan::Impl {
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  VkDescriptorPool descriptors = VK_NULL_HANDLE;
  VkCommandPool commands = VK_NULL_HANDLE;
  ImGui_ImplVulkan_InitInfo info{};
  VkRenderPass renderPass = VK_NULL_HANDLE;
  UiScale scale{0.0f, 0.0f};
  bool glfwReady = false, vulkanReady = false;

  ~Impl() {
    if (device) vkDeviceWaitIdle(device);
    if (vulkanReady) ImGui_ImplVulkan_Shutdown();
    if (glfwReady) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    if (commands) vkDestroyCommandPool(device, commands, nullptr);
    if (descriptors) vkDestroyDescriptorPool(device, descriptors, nullptr);
  }
  void makePools(std::uint32_t queueFamily);
  void submitAndWait(VkCommandBuffer commandBuffer);
};

void ImguiVulkan::Impl::makePools(std::uint32_t queueFamily) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 4};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  pool.maxSets = 4;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &size;
  require(vkCreateDescriptorPool(device, &pool, nullptr, &descriptors), "descriptor pool");

  VkCommandPoolCreateInfo commandPool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  commandPool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  commandPool.queueFamilyIndex = queueFamily;
  require(vkCreateCommandPool(device, &commandPool, nullptr, &commands), "command pool");
}

void ImguiVulkan::Impl::submitAndWait(VkCommandBuffer commandBuffer) {
  VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  require(vkCreateFence(device, &fenceInfo, nullptr, &fence), "fence");
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commandBuffer;
  VkResult result = vkQueueSubmit(queue, 1, &submit, fence);
  if (result == VK_SUCCESS) result = vkWaitForFences(device, 1, &fence, VK_TRUE, kUploadTimeoutNs);
  vkDestroyFence(device, fence, nullptr);
  require(result, "font texture");
}

ImguiVulkan::ImguiVulkan(const Window& window, const Presenter::Handles& handles)
    : impl_(std::make_unique<Impl>()) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the layout is ours; nothing is written into the working folder
  impl_->glfwReady = ImGui_ImplGlfw_InitForVulkan(window.handle(), true);

  impl_->device = static_cast<VkDevice>(handles.device);
  impl_->queue = static_cast<VkQueue>(handles.queue);
  impl_->makePools(handles.queueFamily);

  ImGui_ImplVulkan_InitInfo& info = impl_->info;
  info.Instance = static_cast<VkInstance>(handles.instance);
  info.PhysicalDevice = static_cast<VkPhysicalDevice>(handles.physicalDevice);
  info.Device = impl_->device;
  info.QueueFamily = handles.queueFamily;
  info.Queue = impl_->queue;
  info.DescriptorPool = impl_->descriptors;
  info.MinImageCount = 2;
  info.ImageCount = std::max(handles.imageCount, 2u);
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = [](VkResult result) {
    if (result < 0) require(result, "buffers");
  };
  impl_->renderPass = VkRenderPass(handles.renderPass);
  setScale(window.scale());
}

ImguiVulkan::~ImguiVulkan() = default;

bool ImguiVulkan::setScale(UiScale scale) {
  if (scale == impl_->scale) return false;
  impl_->scale = scale;
  applyStyle(scale);
  loadFonts(scale);
  // ImGui 1.86 would leak the old font texture: only a restart of its Vulkan part frees it.
  vkDeviceWaitIdle(impl_->device);
  if (impl_->vulkanReady) ImGui_ImplVulkan_Shutdown();
  impl_->vulkanReady = ImGui_ImplVulkan_Init(&impl_->info, impl_->renderPass);
  uploadFonts();
  return true;
}

void ImguiVulkan::uploadFonts() {
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = impl_->commands;
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commandBuffer = VK_NULL_HANDLE;
  require(vkAllocateCommandBuffers(impl_->device, &allocate, &commandBuffer), "command buffer");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  require(vkBeginCommandBuffer(commandBuffer, &begin), "command buffer");
  ImGui_ImplVulkan_CreateFontsTexture(commandBuffer);
  require(vkEndCommandBuffer(commandBuffer), "command buffer");
  impl_->submitAndWait(commandBuffer);
  ImGui_ImplVulkan_DestroyFontUploadObjects();
  vkFreeCommandBuffers(impl_->device, impl_->commands, 1, &commandBuffer);
}

void ImguiVulkan::beginFrame() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void ImguiVulkan::endFrame() {
  ImGui::Render();
}

void ImguiVulkan::draw(void* vkCommandBuffer) {
  if (ImDrawData* data = ImGui::GetDrawData())
    ImGui_ImplVulkan_RenderDrawData(data, static_cast<VkCommandBuffer>(vkCommandBuffer));
}

}  // namespace steradian::ui
