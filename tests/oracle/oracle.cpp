// SPDX-License-Identifier: MIT
#include "tests/oracle/oracle.hpp"

#include <atomic>
#include <thread>

#include "tests/oracle/path.hpp"

namespace steradian::oracle {
namespace {

struct Job {
  const Scene& scene;
  const CameraView& view;
  const World world{scene};
  int samples;
  std::uint64_t seed;
};

void tracePixel(const Job& job, Estimate& image, int x, int y) {
  std::seed_seq seed{std::uint32_t(job.seed), std::uint32_t(job.seed >> 32), std::uint32_t(x),
                     std::uint32_t(y)};
  Random random(seed);
  dvec3 mean(0.0), squares(0.0);  // Welford 1962
  for (int i = 0; i < job.samples; ++i) {
    const Ray ray = cameraRay(job.scene, job.view, {x, y}, {image.width, image.height}, random);
    const dvec3 L = radiance(job.world, ray, job.scene.render.maxBounces, random);
    const dvec3 off = L - mean;
    mean += off / double(i + 1);
    squares += off * (L - mean);
  }
  const std::size_t pixel = std::size_t(y) * image.width + x;
  image.mean[pixel] = mean;
  image.variance[pixel] = squares / double(job.samples - 1);
}

}  // namespace

Estimate trace(const Scene& scene, const CameraView& view, int width, int height, int samples,
               std::uint64_t seed) {
  const std::size_t pixels = std::size_t(width) * height;
  Estimate image{width, height, double(samples), std::vector<dvec3>(pixels), std::vector<dvec3>(pixels)};
  const Job job{.scene = scene, .view = view, .samples = samples, .seed = seed};
  std::atomic<int> nextRow{0};
  const auto work = [&] {
    for (int y = nextRow++; y < height; y = nextRow++)
      for (int x = 0; x < width; ++x) tracePixel(job, image, x, y);
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return image;
}

}  // namespace steradian::oracle
