// SPDX-License-Identifier: MIT
#include "renderer/error_meter.hpp"

#include <algorithm>

#include "renderer/gpu/barriers.hpp"
#include "renderer/shader_code.hpp"

namespace steradian {

using namespace gpu;

ErrorMeter::ErrorMeter(const Device& device)
    : device_(device), pass_(device, meterSpirv(), {}, "meter"), commands_(device, QueueKind::compute) {}

MeterReading ErrorMeter::read(const Film& film, bool errorMeter) {
  commands_.run([&](const auto& cmd) {
    computeToCompute(cmd);
    pass_.dispatch(cmd, film.bindings(), film.params(errorMeter), film.meterGroups(), 1);
  });
  const auto rows = downloadAs<float>(device_, film.partials(), 0, std::size_t(film.meterGroups()) * 4);
  const auto counters = downloadAs<std::uint32_t>(device_, film.counters(), 0, COUNTERS);
  double sums[4] = {};
  for (std::size_t i = 0; i < rows.size(); ++i) sums[i % 4] += rows[i];
  const double pixels = double(film.pixels());
  const double cut =
      (counters[COUNTER_CLAMPED_HIGH] * 4294967296.0 + counters[COUNTER_CLAMPED_LOW]) / CLAMPED_UNITS;
  const FilmParams params = film.params(errorMeter);
  const double samples = std::max(1.0, double(params.samplesA) + params.samplesB);
  return {sums[0] / pixels,       sums[1] / pixels,       counters[COUNTER_NAN],   counters[COUNTER_FAULTS],
          std::uint64_t(sums[2]), std::uint64_t(sums[3]), cut / (pixels * samples)};
}

}  // namespace steradian
