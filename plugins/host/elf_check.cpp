// SPDX-License-Identifier: MIT
// Reads a plugin's version from its ELF note (System V ABI, "Note Section") without running any of its code.
#include "plugins/host/elf_check.hpp"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <optional>
#include <vector>

#include "steradian/plugin.hpp"

namespace steradian::plugins {

namespace {

#if defined(__x86_64__)
constexpr int kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr int kMachine = EM_AARCH64;
#else
#error "tell the host its ELF machine number"
#endif

/// Bounded reads at absolute offsets; a short file reads as absent.
class FileReader {
 public:
  explicit FileReader(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    std::error_code none;
    size_ = std::filesystem::is_regular_file(path, none) ? std::filesystem::file_size(path, none) : 0;
  }
  std::uint64_t size() const { return size_; }
  bool read(std::uint64_t offset, void* to, std::uint64_t count) {
    if (count > size_ || offset > size_ - count) return false;
    stream_.clear();
    return bool(stream_.seekg(std::streamoff(offset)).read(static_cast<char*>(to), std::streamsize(count)));
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

/// Looks for our note in one PT_NOTE segment.
std::optional<sdk::VersionNote> findNote(const std::vector<char>& segment) {
  for (std::size_t at = 0; at + sizeof(Elf64_Nhdr) <= segment.size();) {
    Elf64_Nhdr header;
    std::memcpy(&header, segment.data() + at, sizeof header);
    const auto padded = [](std::uint64_t n) { return (n + 3) & ~std::uint64_t(3); };
    const std::uint64_t length = sizeof header + padded(header.n_namesz) + padded(header.n_descsz);
    if (length > segment.size() - at) return std::nullopt;
    if (header.n_type == 1 && header.n_namesz == 5 && header.n_descsz >= 16 &&
        std::memcmp(segment.data() + at + sizeof header, "STRD", 5) == 0) {
      sdk::VersionNote note;
      std::memcpy(&note, segment.data() + at, sizeof note);
      return note;
    }
    at += length;
  }
  return std::nullopt;
}

std::optional<sdk::VersionNote> noteOf(FileReader& file, const Elf64_Ehdr& header) {
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment;
    if (!file.read(header.e_phoff + std::uint64_t(i) * header.e_phentsize, &segment, sizeof segment)) break;
    if (segment.p_type != PT_NOTE || segment.p_filesz > (1u << 20)) continue;
    std::vector<char> bytes(segment.p_filesz);
    if (!file.read(segment.p_offset, bytes.data(), bytes.size())) continue;
    if (auto note = findNote(bytes)) return note;
  }
  return std::nullopt;
}

/// A segment beyond the end of the file would be mapped and then kill whoever touches it (SIGBUS).
bool truncated(FileReader& file, const Elf64_Ehdr& header) {
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment;
    if (!file.read(header.e_phoff + std::uint64_t(i) * header.e_phentsize, &segment, sizeof segment))
      return true;
    if (segment.p_filesz > file.size() || segment.p_offset > file.size() - segment.p_filesz) return true;
  }
  return false;
}

std::string version(std::uint32_t major, std::uint32_t minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

}  // namespace

std::string interfaceMismatch(std::uint32_t magic, std::uint32_t major, std::uint32_t minor,
                              std::uint32_t size) {
  if (magic != sdk::kMagic)
    return "is not a Steradian plugin: its entry does not begin with the magic number";
  if (major != sdk::kMajor || minor > sdk::kMinor)
    return "built for interface " + version(major, minor) + ", this host speaks " +
           version(sdk::kMajor, sdk::kMinor) +
           (major < sdk::kMajor ? "; rebuild the plugin" : "; update Steradian or rebuild the plugin");
  if (size < sizeof(sdk::PluginEntry))
    return "its entry has " + std::to_string(size) + " bytes, expected at least " +
           std::to_string(sizeof(sdk::PluginEntry)) + "; rebuild the plugin";
  return {};
}

std::string reasonNotLoadable(const std::filesystem::path& path) {
  FileReader file(path);
  Elf64_Ehdr header;
  if (!file.read(0, &header, sizeof header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
    return "is not a shared library (no ELF header)";
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_machine != kMachine)
    return "is built for another processor (ELF machine " + std::to_string(header.e_machine) +
           ", this one is " + std::to_string(kMachine) + ")";
  if (header.e_phentsize < sizeof(Elf64_Phdr) || truncated(file, header)) return "is truncated";
  const auto note = noteOf(file, header);
  if (!note) return "is not a Steradian plugin: it has no version note (use the macro STERADIAN_PLUGIN)";
  return interfaceMismatch(note->magic, note->major, note->minor, note->entrySize);
}

}  // namespace steradian::plugins
