// SPDX-License-Identifier: MIT
// steradian compare --verify-pixel: the device's float against the same functions in double.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace steradian::cli {

/// What `--verify-pixel` was asked for.
struct VerifyOptions {
  std::string pixels;  // as typed; empty = not asked for
  std::optional<std::uint64_t> sample;
  std::string size, camera, device;
};

/// Adds the options to `steradian compare`.
std::shared_ptr<VerifyOptions> addVerifyOptions(CLI::App& compare);

/// Prints where float and double part; 1 when they do by more than rounding explains. Throws Error(usage) for
/// pixels outside the film, and what prepareScene() and recordPaths() throw.
int runVerify(const VerifyOptions& options, const std::filesystem::path& project);

}  // namespace steradian::cli
