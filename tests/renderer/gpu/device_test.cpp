// SPDX-License-Identifier: MIT
// Device choice, faults of the machine, submission, memory, pipeline cache.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <thread>

#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/buffer.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/device.hpp"
#include "renderer/gpu/pass.hpp"
#include "renderer/gpu/pipeline_cache.hpp"
#include "renderer/scene/error.hpp"

#include "add_comp.h"

namespace steradian::gpu {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<Device> open(const std::string& name = {}) {
  return openDevice({name, true, nullptr});
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::noDevice);
    return error.what();
  }
  return "no error";
}

TEST(Devices, OneIsTheDefaultAndItIsUsable) {
  const auto devices = describeDevices();
  ASSERT_FALSE(devices.empty());
  int chosen = 0;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    EXPECT_EQ(devices[i].index, int(i));
    EXPECT_FALSE(devices[i].name.empty());
    EXPECT_EQ(devices[i].usable, devices[i].reason.empty());
    chosen += devices[i].chosen;
    if (devices[i].chosen) {
      EXPECT_TRUE(devices[i].usable);
    }
  }
  EXPECT_EQ(chosen, 1);
}

TEST(Devices, OpenByIndexAndByPartOfTheNameInAnyCase) {
  const DeviceDescription best = describe(*open());
  EXPECT_EQ(describe(*open(std::to_string(best.index))).name, best.name);
  std::string part = best.name.substr(1, 5);
  for (char& c : part) c = char(std::isupper(c) ? std::tolower(c) : std::toupper(c));
  EXPECT_NE(part, best.name.substr(1, 5));
  EXPECT_NE(describe(*open(part)).name.find(best.name.substr(1, 5)), std::string::npos);
}

TEST(Devices, AnUnknownNameOrIndexListsWhatThereIs) {
  const std::string name = describe(*open()).name;
  for (const char* wanted : {"Voodoo 2", "99", "-1"}) {
    const std::string message = messageOf([&] { open(wanted); });
    EXPECT_NE(message.find(wanted), std::string::npos) << message;
    EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

void failWithDriverFile(const char* path) {
  setenv("VK_DRIVER_FILES", path, 1);
  setenv("VK_ICD_FILENAMES", path, 1);
  const std::string list = messageOf([] { describeDevices(); });
  const std::string opened = messageOf([] { openDevice({}); });
  std::fprintf(stderr, "%s | %s\n", list.c_str(), opened.c_str());
  const bool hinted = list.find("mesa-vulkan-drivers") != std::string::npos &&
                      opened.find("mesa-vulkan-drivers") != std::string::npos;
  std::exit(hinted ? 0 : 1);
}

TEST(DevicesDeathTest, WithoutADriverThePackageIsNamed) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(failWithDriverFile("/none.json"), testing::ExitedWithCode(0), "no Vulkan driver was found");
}

TEST(DevicesDeathTest, ABrokenDriverDescriptionIsNotCalledOutOfMemoryAlone) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const fs::path broken = fs::path(testing::TempDir()) / "broken_icd.json";
  std::ofstream(broken) << "{ \"file_format_version\": ";
  EXPECT_EXIT(failWithDriverFile(broken.c_str()), testing::ExitedWithCode(0), "Vulkan driver");
}

TEST(Device, TwoInOneProcessWorkSideBySide) {
  const auto first = open(), second = open();
  for (const auto& device : {first, second}) {
    const Buffer buffer(*device, BufferKind::deviceLocal, 64, "test");
    fillZero(*device, buffer);
    EXPECT_EQ(downloadAs<std::uint32_t>(*device, buffer, 0, 16), std::vector<std::uint32_t>(16, 0));
    EXPECT_EQ(validationMessages(*device), 0);
  }
}

TEST(Device, MisuseIsCountedByTheValidationLayer) {
  const auto device = open();
  testing::internal::CaptureStderr();
  const vk::BufferCreateInfo useless({}, 64, {});  // a buffer for no use at all: forbidden, harmless
  const vk::raii::Buffer buffer(device->handle(), useless);
  const std::string printed = testing::internal::GetCapturedStderr();
  EXPECT_GT(validationMessages(*device), 0);
  EXPECT_NE(printed.find("Vulkan validation"), std::string::npos);
}

TEST(Device, AMissingBarrierIsCountedBySynchronizationValidation) {
  const auto device = open();
  const Buffer buffer(*device, BufferKind::deviceLocal, 64, "test");
  testing::internal::CaptureStderr();
  device->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
    cmd.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, 1);
    cmd.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, 2);
  });
  const std::string printed = testing::internal::GetCapturedStderr();
  EXPECT_GT(validationMessages(*device), 0);
  EXPECT_NE(printed.find("WRITE_AFTER_WRITE"), std::string::npos) << printed;
}

TEST(Device, LossIsForEver) {
  const auto device = open();
  Commands commands(*device, QueueKind::compute);
  device->markLost();
  EXPECT_NE(messageOf([&] { commands.begin(); }).find("lost"), std::string::npos);
  EXPECT_NE(messageOf([&] { device->run(QueueKind::graphics, [](const auto&) {}); }).find("lost"),
            std::string::npos);
}

TEST(Buffer, WhatIsWrittenComesBack) {
  const auto device = open();
  std::vector<float> values(4096);
  std::iota(values.begin(), values.end(), 0.5f);
  Buffer buffer(*device, BufferKind::upload, values.size() * 4, "test");
  buffer.writeRows<float>(0, values);
  EXPECT_EQ(downloadAs<float>(*device, buffer, 0, values.size()), values);
  const std::vector<float> patch = {-1.0f, -2.0f};
  buffer.writeRows<float>(400, patch);
  EXPECT_EQ(downloadAs<float>(*device, buffer, 396, 4), (std::vector<float>{99.5f, -1.0f, -2.0f, 102.5f}));
  EXPECT_EQ(validationMessages(*device), 0);
}

TEST(Buffer, MemoryThatTheHostCannotReachIsWrittenByACopy) {
  const auto device = open();
  std::vector<float> values(1024, 0.25f);
  Buffer buffer(*device, BufferKind::deviceLocal, values.size() * 4, "test");
  ASSERT_EQ(buffer.map(), nullptr);
  buffer.writeRows<float>(0, values);
  const std::vector<float> patch = {3.0f};
  buffer.writeRows<float>(8, patch);
  values[2] = 3.0f;
  EXPECT_EQ(downloadAs<float>(*device, buffer, 0, values.size()), values);
  EXPECT_EQ(validationMessages(*device), 0);
}

TEST(Buffer, OneLargerThanTheDeviceAllowsNamesNeedAndLimit) {
  const auto device = open();
  const std::size_t limit = device->limits().maxStorageBufferRange;
  const std::string message =
      messageOf([&] { Buffer(*device, BufferKind::deviceLocal, limit + (1u << 20), "film"); });
  EXPECT_NE(message.find("film"), std::string::npos) << message;
  EXPECT_NE(message.find(std::to_string(limit >> 20) + " MiB"), std::string::npos) << message;
}

TEST(Commands, AreReusableAndMeasureTime) {
  const auto device = open();
  const Buffer buffer(*device, BufferKind::deviceLocal, 32u << 20, "test");
  Commands commands(*device, QueueKind::compute);
  EXPECT_TRUE(commands.done());
  for (int i = 0; i < 3; ++i) {
    commands.submit([&](const vk::raii::CommandBuffer& cmd) { recordFillZero(cmd, buffer); });
    commands.wait();
    EXPECT_TRUE(commands.done());
    EXPECT_GT(commands.milliseconds(), 0.0);
    EXPECT_LT(commands.milliseconds(), 5000.0);
  }
  EXPECT_EQ(validationMessages(*device), 0);
}

TEST(Commands, OfSeveralThreadsShareOneQueue) {
  const auto device = open();
  const auto work = [&](std::uint32_t value) {
    const Buffer buffer(*device, BufferKind::deviceLocal, 4096, "test");
    for (int i = 0; i < 50; ++i)
      device->run(QueueKind::compute, [&](const vk::raii::CommandBuffer& cmd) {
        computeToTransfer(cmd);
        cmd.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, value);
      });
    EXPECT_EQ(downloadAs<std::uint32_t>(*device, buffer, 0, 1024), std::vector<std::uint32_t>(1024, value));
  };
  std::thread first(work, 1u), second(work, 2u);
  first.join();
  second.join();
  EXPECT_EQ(validationMessages(*device), 0);
}

TEST(Ownership, ABufferKeepsItsContentsOnTheWayToTheGraphicsQueueAndBack) {
  const auto device = open();
  const Buffer buffer(*device, BufferKind::deviceLocal, 256, "test");
  const auto fill = [&](std::uint32_t value) {
    return [&buffer, value](const vk::raii::CommandBuffer& cmd) {
      computeToTransfer(cmd);
      cmd.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, value);
    };
  };
  const Buffer* const buffers[] = {&buffer};
  device->run(QueueKind::compute, fill(7));
  handOver(*device, buffers, QueueKind::compute, QueueKind::graphics);
  EXPECT_EQ(downloadAs<std::uint32_t>(*device, buffer, 0, 1, QueueKind::graphics)[0], 7u);
  handOver(*device, buffers, QueueKind::graphics, QueueKind::compute);
  EXPECT_EQ(downloadAs<std::uint32_t>(*device, buffer, 0, 1)[0], 7u);
  EXPECT_EQ(validationMessages(*device), 0);
}

// The way of a frame: both submissions in flight, joined by a semaphore.
TEST(Ownership, TheSemaphorePathHandsTheBufferOver) {
  const auto device = open();
  const Buffer buffer(*device, BufferKind::deviceLocal, 1024, "test");
  const Buffer seen(*device, BufferKind::readback, 1024, "test");
  const std::uint32_t from = device->compute().family, to = device->graphics().family;
  Commands compute(*device, QueueKind::compute), graphics(*device, QueueKind::graphics);
  const vk::raii::Semaphore written = makeSemaphore(*device), free = makeSemaphore(*device);
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    const Wait waitFree[] = {{*free}}, waitWritten[] = {{*written}};
    const vk::Semaphore signalWritten[] = {*written}, signalFree[] = {*free};
    compute.submit(
        [&](const vk::raii::CommandBuffer& cmd) {
          if (frame) acquire(cmd, buffer, to, from);
          computeToTransfer(cmd);
          cmd.fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, frame);
          release(cmd, buffer, from, to);
        },
        frame ? std::span<const Wait>(waitFree) : std::span<const Wait>(), signalWritten);
    graphics.submit(
        [&](const vk::raii::CommandBuffer& cmd) {
          acquire(cmd, buffer, from, to);
          computeToTransfer(cmd);
          cmd.copyBuffer(buffer.handle(), seen.handle(), vk::BufferCopy(0, 0, 1024));
          transferToHost(cmd);
          release(cmd, buffer, to, from);
        },
        waitWritten, signalFree);
    graphics.wait();
    std::uint32_t first;
    std::memcpy(&first, seen.map(), sizeof(first));
    EXPECT_EQ(first, frame);
  }
  compute.wait();
  EXPECT_EQ(validationMessages(*device), 0);
}

/// A cache folder of its own for one test.
class PipelineCacheFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("steradian_cache_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    if (const char* old = std::getenv("XDG_CACHE_HOME")) old_ = old;
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
  }
  void TearDown() override {
    old_.empty() ? unsetenv("XDG_CACHE_HOME") : setenv("XDG_CACHE_HOME", old_.c_str(), 1);
    fs::remove_all(folder_);
  }
  static void compileSomething() {
    const auto device = open();
    const ComputePass pass(*device, add_comp, {}, "add");
    EXPECT_EQ(validationMessages(*device), 0);
  }
  static std::string contents(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static fs::path file() { return *PipelineCache::file(open()->physical().getProperties()); }

  fs::path folder_;
  std::string old_;
};

TEST_F(PipelineCacheFile, IsWrittenBesideNothingElse) {
  compileSomething();
  const fs::path path = file();
  EXPECT_EQ(path.parent_path(), folder_ / "steradian");
  ASSERT_TRUE(fs::exists(path));
  EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()), 1);
}

// A cache that is accepted and grew by nothing is not written again, so damage that stays was accepted.
TEST_F(PipelineCacheFile, ADamagedOneIsIgnoredAndReplaced) {
  compileSomething();
  const fs::path path = file();
  const std::string intact = contents(path);
  ASSERT_GT(intact.size(), 32u);
  for (const std::size_t at : {std::size_t(0), std::size_t(20), intact.size() / 2, intact.size() - 1}) {
    std::string damaged = intact;
    damaged[at] = char(damaged[at] ^ 0x5a);
    std::ofstream(path, std::ios::binary) << damaged;
    compileSomething();
    EXPECT_NE(contents(path), damaged) << "byte " << at;
  }
  fs::resize_file(path, 7);
  compileSomething();
  EXPECT_GT(fs::file_size(path), 32u);
}

TEST_F(PipelineCacheFile, AnIntactOneIsKept) {
  compileSomething();
  const fs::path path = file();
  const auto written = fs::last_write_time(path);
  compileSomething();
  EXPECT_EQ(fs::last_write_time(path), written);
}

TEST_F(PipelineCacheFile, IsLeftOutWhenThereIsNoFolderForIt) {
  const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
  unsetenv("XDG_CACHE_HOME");
  unsetenv("HOME");
  EXPECT_FALSE(PipelineCache::file({}).has_value());
  compileSomething();
  if (!home.empty()) setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace steradian::gpu
