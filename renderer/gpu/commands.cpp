// SPDX-License-Identifier: MIT
// Submission with a time-out and a stopwatch on the device.
#include "renderer/gpu/commands.hpp"

#include <cassert>

#include "renderer/scene/error.hpp"

namespace steradian::gpu {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

vk::raii::CommandPool makePool(const Device& device, std::uint32_t family) {
  const vk::CommandPoolCreateInfo info(vk::CommandPoolCreateFlagBits::eTransient, family);
  return checked(device, "creating a command pool",
                 [&] { return vk::raii::CommandPool(device.handle(), info); });
}

vk::raii::CommandBuffer makeBuffer(const Device& device, const vk::raii::CommandPool& pool) {
  const vk::CommandBufferAllocateInfo info(*pool, vk::CommandBufferLevel::ePrimary, 1);
  return checked(device, "creating a command buffer",
                 [&] { return std::move(vk::raii::CommandBuffers(device.handle(), info).front()); });
}

vk::raii::Fence makeFence(const Device& device) {
  const vk::FenceCreateInfo info;
  return checked(device, "creating a fence", [&] { return vk::raii::Fence(device.handle(), info); });
}

vk::raii::QueryPool makeTimestamps(const Device& device, const QueueRef& queue) {
  if (queue.timestampBits == 0) return nullptr;
  const vk::QueryPoolCreateInfo info({}, vk::QueryType::eTimestamp, 2);
  return checked(device, "creating timestamps", [&] { return vk::raii::QueryPool(device.handle(), info); });
}

}  // namespace

std::chrono::seconds answerTimeout(const Device& device) {
  return std::chrono::seconds(device.description().type == "CPU" ? 60 : 10);
}

Commands::Commands(const Device& device, QueueKind kind)
    : device_(device),
      queue_(device.queue(kind)),
      pool_(makePool(device, queue_.family)),
      buffer_(makeBuffer(device, pool_)),
      fence_(makeFence(device)),
      timestamps_(makeTimestamps(device, queue_)) {}

Commands::~Commands() {
  if (!inFlight_) return;
  // Also when the device is lost: one that was only too slow still uses what is about to be freed. One that
  // is really lost answers at once. Errors are remembered by the device; whoever submits next is told.
  try {
    const auto timeout = std::chrono::duration_cast<std::chrono::nanoseconds>(answerTimeout(device_)).count();
    const vk::Result result = device_.handle().waitForFences(*fence_, VK_TRUE, std::uint64_t(timeout));
    if (result != vk::Result::eSuccess) device_.markLost();
  } catch (const vk::SystemError&) {
    device_.markLost();
  }
}

const vk::raii::CommandBuffer& Commands::begin() {
  wait();
  device_.throwIfLost();
  checked(device_, "starting to record", [&] {
    pool_.reset();
    buffer_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  });
  if (*timestamps_) {
    buffer_.resetQueryPool(*timestamps_, 0, 2);
    buffer_.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *timestamps_, 0);  // after earlier work
  }
  return buffer_;
}

void Commands::submit(std::span<const Wait> waits, std::span<const vk::Semaphore> signals) {
  assert(!inFlight_ && "begin() comes before submit()");
  if (*timestamps_) buffer_.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *timestamps_, 1);
  std::vector<vk::Semaphore> semaphores;
  std::vector<vk::PipelineStageFlags> stages;
  for (const Wait& wait : waits) {
    semaphores.push_back(wait.semaphore);
    stages.push_back(wait.stage);
  }
  const vk::CommandBuffer buffer = *buffer_;
  vk::SubmitInfo info(semaphores, stages, buffer);
  info.signalSemaphoreCount = std::uint32_t(signals.size());
  info.pSignalSemaphores = signals.data();
  checked(device_, "submitting work", [&] {
    buffer_.end();
    const std::lock_guard lock(queue_.mutex);
    queue_.handle.submit(info, *fence_);
  });
  submitted_ = std::chrono::steady_clock::now();
  inFlight_ = true;
}

void Commands::submit(const Record& record, std::span<const Wait> waits,
                      std::span<const vk::Semaphore> signals) {
  record(begin());
  submit(waits, signals);
}

bool Commands::done() {
  if (!inFlight_) return true;
  device_.throwIfLost();
  const vk::Result status = checked(device_, "asking the device", [&] { return fence_.getStatus(); });
  if (status == vk::Result::eSuccess) finish();
  return !inFlight_;
}

void Commands::wait() {
  if (!inFlight_) return;
  device_.throwIfLost();
  const auto timeout = std::chrono::duration_cast<std::chrono::nanoseconds>(answerTimeout(device_)).count();
  const vk::Result result = checked(device_, "waiting for the device", [&] {
    return device_.handle().waitForFences(*fence_, VK_TRUE, std::uint64_t(timeout));
  });
  if (result == vk::Result::eSuccess) return finish();
  device_.markLost();
  throw Error(ExitCode::noDevice, device_.description().name + ": the device did not answer in " +
                                      std::to_string(answerTimeout(device_).count()) +
                                      " s and is taken for lost");
}

double Commands::run(const Record& record) {
  submit(record);
  wait();
  return milliseconds_;
}

void Commands::finish() {
  inFlight_ = false;
  milliseconds_ = millisecondsSince(submitted_);
  checked(device_, "resetting a fence", [&] { device_.handle().resetFences(*fence_); });
  if (!*timestamps_) return;
  const auto [result, ticks] = timestamps_.getResults<std::uint64_t>(
      0, 2, 2 * sizeof(std::uint64_t), sizeof(std::uint64_t), vk::QueryResultFlagBits::e64);
  if (result != vk::Result::eSuccess) return;
  const std::uint32_t bits = queue_.timestampBits;
  const std::uint64_t mask = bits >= 64 ? ~0ull : (1ull << bits) - 1;  // the counter may wrap in between
  milliseconds_ = double((ticks[1] - ticks[0]) & mask) * device_.limits().timestampPeriod * 1e-6;
}

vk::raii::Semaphore makeSemaphore(const Device& device) {
  const vk::SemaphoreCreateInfo info;
  return checked(device, "creating a semaphore", [&] { return vk::raii::Semaphore(device.handle(), info); });
}

}  // namespace steradian::gpu
