// SPDX-License-Identifier: MIT
// The host's side of one import or export: services, parameters, the bytes written, and the verdict.
#pragma once
#include <deque>
#include <exception>
#include <map>
#include <string>

#include "plugins/host/plugin_host.hpp"
#include "steradian/plugin.hpp"

namespace steradian::plugins {

class Call final : public sdk::Host {
 public:
  /// Throws Error(usage) when a parameter is unknown or out of range.
  Call(const Contribution& contribution, const std::filesystem::path& file, const Progress& progress,
       const Parameters& parameters);

  void log(sdk::Text message) noexcept override;
  void progress(double fraction) noexcept override;
  bool cancelled() noexcept override;
  void fail(sdk::Text message) noexcept override;
  double parameter(sdk::Text id) noexcept override;
  void notKept(sdk::Text what, sdk::Text why) noexcept override;
  bool readBeside(sdk::Text path, sdk::Text& bytes) noexcept override;

  /// Returns when `status` is ok and nothing failed on our side, else throws the one line for the user.
  void judge(sdk::Status status) const;
  ImportReport report;

 private:
  template <class Work>
  void keeping(Work&& work) noexcept;

  const Contribution& contribution_;
  std::filesystem::path path_;
  std::string file_;
  std::deque<std::string> beside_;  // files that were read, or why not
  const Progress& progress_;
  Parameters values_;
  std::string message_;
  std::exception_ptr ours_;  // thrown by a callback of the editor; not the plugin's to see
};

/// Collects an exported file in memory, so that a failed export never touches the disk.
class MemoryWriter final : public sdk::Writer {
 public:
  explicit MemoryWriter(std::string stem) : stem_(std::move(stem)) {}
  void write(const void* data, std::uint64_t size) noexcept override;
  void writeBeside(sdk::Text path, const void* data, std::uint64_t size) noexcept override;
  sdk::Text stem() noexcept override { return stem_; }
  bool outOfMemory = false;
  std::string bytes;
  std::map<std::string, std::string> beside;  // relative path -> bytes

 private:
  std::string stem_;
};

}  // namespace steradian::plugins
