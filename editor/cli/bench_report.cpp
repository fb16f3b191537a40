// SPDX-License-Identifier: MIT
// The results of a bench for people and for programs.
#include "editor/cli/bench.hpp"
#include "editor/cli/bench_text.hpp"

namespace steradian::bench {

namespace {

using bench::jsonOf;

Json jsonOf(const Throughput& throughput) {
  return {{"msPerSample", throughput.msPerSample},
          {"samplesPerSecond", 1e3 / throughput.msPerSample},
          {"mraysPerSecond", throughput.mraysPerSecond},
          {"peakOperationsPerRay", jsonOf(throughput.operationsPerRay)},
          {"specialized", throughput.variant.specialized},
          {"features", throughput.variant.features},
          {"leftOut", throughput.variant.leftOut}};
}

Json jsonOf(const BenchResult& result) {
  Json timeToError = Json::array();
  for (const TimeToError& time : result.timeToError)
    timeToError.push_back(
        {{"relRmse", time.relRmse}, {"seconds", jsonOf(time.seconds)}, {"samples", time.samples}});
  return {{"project", result.project},
          {"device", result.device.name},
          {"driver", result.device.driver},
          {"queues", result.device.queues},
          {"width", result.size.width},
          {"height", result.size.height},
          {"maxBounces", result.maxBounces},
          {"special", jsonOf(result.special)},
          {"generic", jsonOf(result.generic)},
          {"speedup", result.generic.msPerSample / result.special.msPerSample},
          {"bitEqual", result.bitEqual},
          {"firstPixelSeconds",
           {{"cold", jsonOf(result.coldFirstPixel)}, {"warm", jsonOf(result.warmFirstPixel)}}},
          {"timeToError", timeToError},
          {"editToPictureMs", result.editMs},
          {"nan", result.nan},
          {"faults", result.faults},
          {"validationMessages", result.validationMessages}};
}

std::string textOf(const BenchResult& result) {
  std::string out = line("%s  %dx%d, %d bounces", result.project.c_str(), result.size.width,
                         result.size.height, result.maxBounces);
  out += line("  %s, %s", result.device.name.c_str(), result.device.queues.c_str());
  for (const auto& [name, variant] :
       {std::pair("special", &result.special), std::pair("generic", &result.generic)}) {
    out += line("  %-8s %10.3f ms/sample  %10.1f samples/s  %10.2f Mrays/s", name, variant->msPerSample,
                1e3 / variant->msPerSample, variant->mraysPerSecond);
    if (variant->operationsPerRay)
      out += line("           %10.0f peak operations per ray", *variant->operationsPerRay);
  }
  out +=
      line("  special is %.2f times as fast, images %s",
           result.generic.msPerSample / result.special.msPerSample, result.bitEqual ? "bit-equal" : "DIFFER");
  if (result.coldFirstPixel && result.warmFirstPixel)
    out += line("  first pixel: cold %.2f s, warm %.2f s", *result.coldFirstPixel, *result.warmFirstPixel);
  for (const TimeToError& time : result.timeToError)
    out += time.seconds ? line("  %g %% relative error after %.2f s, %llu samples", time.relRmse * 100.0,
                               *time.seconds, (unsigned long long)(time.samples))
                        : line("  %g %% relative error not reached within the limit, %llu samples",
                               time.relRmse * 100.0, (unsigned long long)(time.samples));
  out += line("  edit to picture: %.1f ms", result.editMs);
  out += line("  NaN %llu, faults %llu, validation messages %d", (unsigned long long)(result.nan),
              (unsigned long long)(result.faults), result.validationMessages);
  return out;
}

}  // namespace

std::string textOf(const std::vector<BenchResult>& results) {
  std::string out;
  for (const BenchResult& result : results) {
    if (!out.empty()) out += "\n";
    out += textOf(result);
  }
  return out;
}

std::string jsonOf(const std::vector<BenchResult>& results) {
  Json list = Json::array();
  for (const BenchResult& result : results) list.push_back(jsonOf(result));
  return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace steradian::bench
