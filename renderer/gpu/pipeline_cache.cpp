// SPDX-License-Identifier: MIT
// Reads and writes the pipeline cache file.
#include "renderer/gpu/pipeline_cache.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

namespace steradian::gpu {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> cacheFolder() {
  const char* xdg = std::getenv("XDG_CACHE_HOME");
  if (xdg && xdg[0] == '/') return fs::path(xdg) / "steradian";  // the XDG rule: ignore relative paths
  const char* home = std::getenv("HOME");
  if (home && home[0] == '/') return fs::path(home) / ".cache" / "steradian";
  return std::nullopt;
}

std::vector<char> readAll(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > (256u << 20)) return {};
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Drivers are not bound to survive a damaged body, so a checksum (FNV-1a, 64 bits) guards the driver's bytes.
std::uint64_t checksum(const char* bytes, std::size_t count) {
  std::uint64_t hash = 14695981039346656037ull;
  for (std::size_t i = 0; i < count; ++i)
    hash = (hash ^ static_cast<unsigned char>(bytes[i])) * 1099511628211ull;
  return hash;
}

bool isOurs(const std::vector<char>& data, const vk::PhysicalDeviceProperties& properties) {
  VkPipelineCacheHeaderVersionOne header;
  std::uint64_t stored;
  if (data.size() < sizeof(header) + sizeof(stored)) return false;
  const std::size_t body = data.size() - sizeof(stored);
  std::memcpy(&header, data.data(), sizeof(header));
  std::memcpy(&stored, data.data() + body, sizeof(stored));
  return stored == checksum(data.data(), body) && header.headerSize >= sizeof(header) &&
         header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
         header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
         std::memcmp(header.pipelineCacheUUID, properties.pipelineCacheUUID.data(), VK_UUID_SIZE) == 0;
}

bool writeAll(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(file, bytes, count);
    if (written <= 0) return false;
    bytes += written;
    count -= std::size_t(written);
  }
  return true;
}

// Temporary sibling, then rename: another process sees the old file or the new one, never a torn one.
void writeAtomically(const fs::path& path, const std::vector<char>& data) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  std::string temporary = path.string() + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) return;
  const bool written = writeAll(file, data.data(), data.size()) && ::fsync(file) == 0;
  ::close(file);
  if (!written || std::rename(temporary.c_str(), path.c_str()) != 0) ::unlink(temporary.c_str());
}

}  // namespace

std::optional<fs::path> PipelineCache::file(const vk::PhysicalDeviceProperties& properties) {
  const std::optional<fs::path> folder = cacheFolder();
  if (!folder) return std::nullopt;
  std::string name = "pipelines-";
  char digits[16];
  for (const std::uint8_t byte : properties.pipelineCacheUUID) {
    std::snprintf(digits, sizeof(digits), "%02x", byte);
    name += digits;
  }
  std::snprintf(digits, sizeof(digits), "-%08x.bin", properties.driverVersion);
  return *folder / (name + digits);
}

PipelineCache::PipelineCache(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device)
    : cache_(nullptr) {
  const vk::PhysicalDeviceProperties properties = physical.getProperties();
  file_ = file(properties);
  std::vector<char> data = file_ ? readAll(*file_) : std::vector<char>();
  if (!isOurs(data, properties)) data.clear();
  if (!data.empty()) data.resize(data.size() - sizeof(std::uint64_t));
  loadedBytes_ = data.size();
  const vk::PipelineCacheCreateInfo info({}, data.size(), data.data());
  try {
    cache_ = vk::raii::PipelineCache(device, info);
  } catch (const vk::SystemError&) {  // the driver refuses the file: start empty
    loadedBytes_ = 0;
    const vk::PipelineCacheCreateInfo empty;
    cache_ = vk::raii::PipelineCache(device, empty);
  }
}

PipelineCache::~PipelineCache() {
  save();
}

void PipelineCache::save() const noexcept {
  if (!file_) return;
  try {
    const std::vector<std::uint8_t> compiled = cache_.getData();
    if (compiled.size() == loadedBytes_) return;
    std::vector<char> data(compiled.begin(), compiled.end());
    const std::uint64_t sum = checksum(data.data(), data.size());
    const char* bytes = reinterpret_cast<const char*>(&sum);
    data.insert(data.end(), bytes, bytes + sizeof(sum));
    writeAtomically(*file_, data);
  } catch (const std::exception&) {  // a cache that cannot be kept costs time, nothing else
  }
}

}  // namespace steradian::gpu
