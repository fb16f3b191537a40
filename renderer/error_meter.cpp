// SPDX-License-Identifier: MIT
#include "renderer/error_meter.hpp"

#include "renderer/gpu/barriers.hpp"
#include "renderer/shader_code.hpp"

namespace steradian {

using namespace gpu;

ErrorMeter::ErrorMeter(const Device& device)
    : device_(device),
      level_(device, levelSpirv(), {}, "level"),
      pass_(device, meterSpirv(), {}, "meter"),
      commands_(device, QueueKind::compute) {}

MeterReading ErrorMeter::read(const Film& film, bool errorMeter, double clampRadiance) {
  commands_.run([&](const auto& cmd) {
    computeToCompute(cmd);
    level_.dispatch(cmd, film.bindings(), film.params(errorMeter), film.meterGroups(), 1);
    computeToCompute(cmd);
    pass_.dispatch(cmd, film.bindings(), film.params(errorMeter), film.meterGroups(), 1);
  });
  const auto rows = downloadAs<float>(device_, film.partials(), 0, film.meterPartials() * METER_ROWS * 4);
  const auto counters = downloadAs<std::uint32_t>(device_, film.counters(), 0, COUNTERS);
  double sums[METER_ROWS * 4] = {};
  for (std::size_t i = 0; i < rows.size(); ++i) sums[i % std::size(sums)] += rows[i];
  const double pixels = double(film.pixels());
  const double cut = (counters[COUNTER_CLAMPED_HIGH] * 4294967296.0 + counters[COUNTER_CLAMPED_LOW]) /
                     CLAMPED_UNITS * clampRadiance;
  const double kept = sums[4];
  return {sums[0] / pixels,
          sums[1] / pixels,
          counters[COUNTER_NAN],
          counters[COUNTER_FAULTS],
          std::uint64_t(sums[2]),
          std::uint64_t(sums[3]),
          cut > 0.0 ? cut / (cut + kept) : 0.0};
}

}  // namespace steradian
