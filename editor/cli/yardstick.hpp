// SPDX-License-Identifier: MIT
// What the processor's vector units give at this moment, to judge rays per second on a CPU driver by: clocks
// and neighbours change both alike.
#pragma once

namespace steradian::bench {

/// 10^9 single-precision multiplications and additions per second, without fused ones (CPU drivers split
/// them), in 256-bit vectors where the processor has them, on `threads` threads at once for `seconds` of wall
/// time.
double vectorGflops(double seconds, unsigned threads);
/// On all hardware threads, for as long as stands well out of the clock and costs a run little.
double vectorGflops();

/// What the vector units could have computed in the time of one ray; smaller is better.
inline double peakOperationsPerRay(double gflops, double mraysPerSecond) {
  return gflops * 1e3 / mraysPerSecond;
}

}  // namespace steradian::bench
