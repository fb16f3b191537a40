// SPDX-License-Identifier: MIT
// Runs the bare kernel of the thesis room (bare_room.comp) on a device and prints what it did: the bar for
// `steradian bench`.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <numeric>

#include "renderer/gpu/barriers.hpp"
#include "renderer/gpu/commands.hpp"
#include "renderer/gpu/pass.hpp"

#include "bare_room_comp.h"

namespace steradian {
namespace {

struct Options {
  std::string device;
  int width = 1280, height = 720;
  double seconds = 5.0;
  std::uint32_t samplesPerDispatch = 16;
};

struct Push {
  std::uint32_t width, height, sampleBegin, sampleCount;
};

using Row = std::array<float, 4>;

/// Two rows for each primitive. normal = position * w + xyz; then albedo and alpha = roughness^2, negative
/// for metal.
std::vector<Row> surfaceRows() {
  const auto ball = [](float x, float y, float z, float r) { return Row{-x / r, -y / r, -z / r, 1.0f / r}; };
  const auto paint = [](float r, float g, float b, float roughness) {
    return Row{r, g, b, roughness * roughness};
  };
  const Row white = paint(0.76f, 0.74f, 0.7f, 0.9f);
  return {ball(-1.3f, 0.9f, -0.9f, 0.9f),
          {1.0f, 0.77f, 0.34f, -0.35f * 0.35f},
          ball(0.35f, 0.65f, -1.7f, 0.65f),
          paint(0.72f, 0.66f, 0.58f, 0.85f),
          ball(1.4f, 0.55f, 0.25f, 0.55f),
          paint(0.04f, 0.3f, 0.36f, 0.2f),
          Row{0, 1, 0, 0},
          paint(0.46f, 0.32f, 0.2f, 0.6f),  // floor
          Row{0, -1, 0, 0},
          white,  // ceiling
          Row{1, 0, 0, 0},
          paint(0.6f, 0.14f, 0.09f, 0.8f),
          Row{-1, 0, 0, 0},
          paint(0.16f, 0.42f, 0.22f, 0.8f),
          Row{0, 0, 1, 0},
          paint(0.34f, 0.42f, 0.56f, 0.7f),  // back wall
          Row{0, 0, -1, 0},
          white};  // front wall
}

double userSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_utime.tv_sec) + double(usage.ru_utime.tv_usec) * 1e-6;
}

class BareRoom {
 public:
  explicit BareRoom(const Options& options) : options_(options) {
    rows_.writeRows<Row>(0, surfaceRows());
    gpu::fillZero(*device_, film_);
    gpu::fillZero(*device_, rays_);
  }

  /// Milliseconds of one dispatch.
  double addSamples() {
    const Push push{std::uint32_t(options_.width), std::uint32_t(options_.height), samples_,
                    options_.samplesPerDispatch};
    samples_ += options_.samplesPerDispatch;
    return commands_.run([&](const vk::raii::CommandBuffer& cmd) {
      gpu::computeToCompute(cmd);
      pass_.dispatch(cmd, bindings_, push, (push.width + 7) / 8, (push.height + 7) / 8);
    });
  }

  /// The rate of what was added within `milliseconds`, of it all the rays and the mean.
  void report(double milliseconds, double seconds, double user, std::uint32_t samples) const {
    const std::size_t pixels = pixelCount();
    const auto film = gpu::downloadAs<Row>(*device_, film_, 0, pixels);
    const auto rays = gpu::downloadAs<std::uint32_t>(*device_, rays_, 0, pixels);
    std::array<double, 4> sum{};
    for (const Row& pixel : film)
      for (int i = 0; i < 4; ++i) sum[i] += double(pixel[i]);
    const double all = double(pixels) * samples_;
    const double closest = std::accumulate(rays.begin(), rays.end(), 0.0) / all, shadow = sum[3] / all;
    const double raysOfRun = (closest + shadow) * double(pixels) * samples;
    std::printf("{\"device\": \"%s\", \"samples\": %u, \"msPerSample\": %.4f, \"wallMsPerSample\": %.4f,\n",
                device_->description().name.c_str(), samples, milliseconds / samples,
                seconds * 1e3 / samples);
    std::printf(" \"userMsPerSample\": %.4f, \"mraysPerSecond\": %.3f, \"raysPerUserSecond\": %.0f,\n",
                user * 1e3 / samples, raysOfRun / milliseconds * 1e-3, raysOfRun / user);
    std::printf(
        " \"closestPerPixelSample\": %.5f, \"shadowPerPixelSample\": %.5f, \"raysPerSample\": %.0f,\n",
        closest, shadow, (closest + shadow) * double(pixels));
    std::printf(" \"meanRadiance\": [%.6f, %.6f, %.6f]}\n", sum[0] / all, sum[1] / all, sum[2] / all);
  }

 private:
  std::size_t pixelCount() const { return std::size_t(options_.width) * std::size_t(options_.height); }

  Options options_;
  std::shared_ptr<gpu::Device> device_ = openDevice({.device = options_.device});
  gpu::Buffer rows_{*device_, gpu::BufferKind::upload, 18 * sizeof(Row), "rows"};
  gpu::Buffer film_{*device_, gpu::BufferKind::upload, pixelCount() * sizeof(Row), "film"};
  gpu::Buffer rays_{*device_, gpu::BufferKind::deviceLocal, pixelCount() * sizeof(std::uint32_t), "rays"};
  std::array<const gpu::Buffer*, 2> storage_{&film_, &rays_};
  gpu::Bindings bindings_{*device_, {.rows = &film_, .tables = &rows_}, storage_};
  gpu::ComputePass pass_{*device_, bare_room_comp, {}, "bare room"};
  gpu::Commands commands_{*device_, gpu::QueueKind::compute};
  std::uint32_t samples_ = 0;
};

void run(const Options& options) {
  BareRoom room(options);
  room.addSamples();  // compiles
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const double userBefore = userSeconds();
  double milliseconds = 0.0;
  std::uint32_t samples = 0;
  while (elapsed() < options.seconds) {
    milliseconds += room.addSamples();
    samples += options.samplesPerDispatch;
  }
  room.report(milliseconds, elapsed(), userSeconds() - userBefore, samples);
}

}  // namespace
}  // namespace steradian

int main(int argc, char** argv) {
  steradian::Options options;
  std::string size = "1280x720";
  CLI::App app("Rays per second of a kernel that knows the thesis room alone");
  app.add_option("--device", options.device, "Vulkan device by index or part of its name");
  app.add_option("--size", size, "Width and height in pixels");
  app.add_option("--seconds", options.seconds, "Tracing time")->check(CLI::PositiveNumber);
  // Four turns of the loop a sample: far below the 65,535 after which some drivers stop every loop.
  app.add_option("--samples-per-dispatch", options.samplesPerDispatch)->check(CLI::Range(1, 4096));
  CLI11_PARSE(app, argc, argv);
  if (std::sscanf(size.c_str(), "%dx%d", &options.width, &options.height) != 2 || options.width < 1 ||
      options.height < 1) {
    std::fprintf(stderr, "--size: a width and a height such as 1280x720, not %s\n", size.c_str());
    return 2;
  }
  try {
    steradian::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
