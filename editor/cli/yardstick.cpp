// SPDX-License-Identifier: MIT
// Independent chains of x = x b + c in registers. Built without contraction (editor/CMakeLists.txt).
#include "editor/cli/yardstick.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

#include "renderer/stopwatch.hpp"

// One binary for any processor: the loader picks the widest form that this one runs.
#if defined(__x86_64__)
#define STERADIAN_WIDEST __attribute__((target_clones("avx2", "default")))
#else
#define STERADIAN_WIDEST
#endif

namespace steradian::bench {

namespace {

constexpr int kLanes = 8;
// Hides the latencies (12 are needed where two of each start per cycle); with b and c they fill 16 registers.
constexpr int kChains = 14;
constexpr int kTurns = 20'000;
using Vector = float __attribute__((vector_size(kLanes * sizeof(float))));

/// Operands come from outside, and the sum goes back: nothing can be folded or left out.
STERADIAN_WIDEST float multiplyAndAdd(float start, float factor, float term) {
  const Vector b = Vector{} + factor, c = Vector{} + term;
  Vector x[kChains];
  for (int k = 0; k < kChains; ++k) x[k] = Vector{} + (start + float(k));
  for (int turn = 0; turn < kTurns; ++turn) {
#pragma GCC unroll 16
    for (int k = 0; k < kChains; ++k) x[k] = x[k] * b + c;
  }
  Vector sum = x[0];
  for (int k = 1; k < kChains; ++k) sum += x[k];
  return sum[0];
}

double gflopsOfThisThread(double seconds) {
  volatile float operand = 0.999f, result = 0.0f;  // chains tend to 1: no denormals, no overflow
  double operations = 0.0, elapsed = 0.0;
  for (const auto start = std::chrono::steady_clock::now(); elapsed < seconds;
       elapsed = secondsSince(start)) {
    result = multiplyAndAdd(operand, operand, 1.0f - operand);
    operations += 2.0 * kLanes * kChains * kTurns;
  }
  return operations / elapsed * 1e-9;
}

}  // namespace

double vectorGflops(double seconds, unsigned threads) {
  std::vector<double> gflops(threads);
  {
    std::vector<std::jthread> workers;
    for (double& own : gflops) workers.emplace_back([&own, seconds] { own = gflopsOfThisThread(seconds); });
  }
  return std::accumulate(gflops.begin(), gflops.end(), 0.0);
}

double vectorGflops() {
  return vectorGflops(0.05, std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace steradian::bench
