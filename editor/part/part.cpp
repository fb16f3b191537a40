// SPDX-License-Identifier: MIT
// Sums without rounding, and the picture they make.
#include "editor/part/part.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "editor/part/exact_sum.hpp"
#include "renderer/relative_error.hpp"

namespace steradian {

namespace {

std::string rangeOf(const Part& part) {
  return std::to_string(part.origin.begin) + ":" + std::to_string(part.origin.end);
}

/// Splits the exact value at every place into as many floats as the most demanding one needs.
std::vector<Image> splitTerms(int width, int height,
                              const std::function<void(ExactSum&, std::size_t)>& addAll) {
  const std::size_t values = std::size_t(width) * height * 3;
  std::vector<Image> terms(1, Image{width, height, 3, std::vector<float>(values)});
  ExactSum sum;
  for (std::size_t i = 0; i < values; ++i) {
    sum.clear();
    addAll(sum, i);
    for (std::size_t k = 0;; ++k) {
      const float taken = takeFloat(sum);
      if (!std::isfinite(taken)) throw Error(ExitCode::badInput, "the sum of the samples is too large");
      if (taken == 0.0f) break;
      if (k == terms.size()) terms.push_back({width, height, 3, std::vector<float>(values)});
      terms[k].pixels[i] = taken;
    }
  }
  return terms;
}

bool finite(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return std::isfinite(v); });
}

void checkWhole(const Part& part, const std::string& name, DroppedSamples dropped) {
  if (part.origin.nan > 0 && dropped == DroppedSamples::refuse)
    throw Error(ExitCode::badInput, name + ": its sums lack " + std::to_string(part.origin.nan) +
                                        " samples that were not a number, which darkens their "
                                        "pixels; --accept-nan merges it all the same");
  for (const auto& half : part.terms)
    for (const Image& term : half)
      if (!finite(term))
        throw Error(ExitCode::badInput, name + ": holds values that are not finite; render this part again");
}

void checkSame(const Part& a, const Part& b, const std::string& nameA, const std::string& nameB) {
  const auto differ = [&](const std::string& what, const std::string& remedy) {
    throw Error(ExitCode::badInput, nameA + " and " + nameB + " " + what + "; " + remedy);
  };
  if (a.width != b.width || a.height != b.height)
    differ("differ in size: " + std::to_string(a.width) + "x" + std::to_string(a.height) + " and " +
               std::to_string(b.width) + "x" + std::to_string(b.height),
           "render both with one --size");
  if (a.origin.version != b.origin.version)
    differ("are of Steradian " + a.origin.version + " and " + b.origin.version,
           "render both with one version");
  if (a.origin.seed != b.origin.seed)
    differ("have the seeds " + std::to_string(a.origin.seed) + " and " + std::to_string(b.origin.seed),
           "render both with one --seed");
  if (a.origin.errorMeter != b.origin.errorMeter)
    differ("are made with and without the error meter", "render both with or both without --no-meter");
  if (a.origin.scene != b.origin.scene)
    differ("show different scenes, cameras or settings",
           "render both from one project with the same options");
}

/// `b` is the part after `a`.
void checkAdjacent(const Part& a, const Part& b, const std::string& nameA, const std::string& nameB) {
  if (b.origin.begin < a.origin.end)
    throw Error(ExitCode::badInput, nameA + " (" + rangeOf(a) + ") and " + nameB + " (" + rangeOf(b) +
                                        ") hold the same samples; give each sample once");
  if (b.origin.begin > a.origin.end)
    throw Error(ExitCode::badInput, "no part holds the samples " + std::to_string(a.origin.end) + ":" +
                                        std::to_string(b.origin.begin) + " between " + nameA + " and " +
                                        nameB + "; render them with --samples");
}

std::uint64_t countOf(const PartOrigin& origin, int half) {
  return samplesOfHalf(origin.begin, origin.end, half, origin.errorMeter);
}

void addMissing(std::vector<plugins::ImageLayer>& layers, const std::vector<plugins::ImageLayer>& more) {
  for (const plugins::ImageLayer& layer : more)
    if (std::ranges::find(layers, layer.name, &plugins::ImageLayer::name) == layers.end())
      layers.push_back(layer);
}

void addTerms(ExactSum& sum, const std::vector<Image>& terms, std::size_t at) {
  for (const Image& term : terms) sum.add(term.pixels[at]);
}

}  // namespace

Part partOf(const FilmSums& sums, PartOrigin origin) {
  if (sums.rowsAhead > 0)
    throw Error(ExitCode::failed, "the part is unfinished: some rows hold more samples than others");
  origin.begin = sums.begin;
  origin.end = sums.end;
  origin.errorMeter = sums.errorMeter;
  Part part{std::move(origin), sums.width, sums.height, {}, {}};
  const std::size_t values = sums.sums[0].size();
  for (std::size_t i = 0; i < values; ++i)
    if (sums.full(i))
      throw Error(ExitCode::failed, "the part cannot be saved: a sum of its samples is too large for a film");
  for (int half = 0; half < (sums.errorMeter ? 2 : 1); ++half)
    part.terms[half] = splitTerms(part.width, part.height, [&](ExactSum& exact, std::size_t i) {
      for (const double term : sums.terms(half, i)) exact.add(term);
    });
  return part;
}

Part merged(std::vector<Part> parts, std::vector<std::string> names, DroppedSamples dropped) {
  if (parts.empty()) throw Error(ExitCode::usage, "there is nothing to merge");
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return parts[a].origin.begin < parts[b].origin.begin; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    checkWhole(parts[order[i]], names[order[i]], dropped);
    if (i == 0) continue;
    checkSame(parts[order[i - 1]], parts[order[i]], names[order[i - 1]], names[order[i]]);
    checkAdjacent(parts[order[i - 1]], parts[order[i]], names[order[i - 1]], names[order[i]]);
  }
  const Part& first = parts[order.front()];
  Part out{first.origin, first.width, first.height, {}, {}};
  for (const std::size_t i : order) addMissing(out.layers, parts[i].layers);
  out.origin.end = parts[order.back()].origin.end;
  out.origin.nan = 0;
  for (const Part& part : parts) {
    out.origin.nan += part.origin.nan;
    out.origin.devices.insert(part.origin.devices.begin(), part.origin.devices.end());
  }
  for (int half = 0; half < (out.origin.errorMeter ? 2 : 1); ++half)
    out.terms[half] = splitTerms(out.width, out.height, [&](ExactSum& sum, std::size_t i) {
      for (const Part& part : parts) addTerms(sum, part.terms[half], i);
    });
  return out;
}

Image meanOf(const Part& part) {
  Image mean{part.width, part.height, 3, std::vector<float>(std::size_t(part.width) * part.height * 3)};
  const double samples = double(std::max<std::uint64_t>(part.origin.end - part.origin.begin, 1));
  ExactSum sum;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    sum.clear();
    for (const auto& half : part.terms) addTerms(sum, half, i);
    mean.pixels[i] = float(sum.rounded() / samples);
  }
  return mean;
}

ErrorEstimate errorOf(const Part& part) {
  ErrorEstimate error;
  const double nA = double(countOf(part.origin, 0)), nB = double(countOf(part.origin, 1));
  error.valid = part.origin.errorMeter && nA > 0.0 && nB > 0.0;
  if (!error.valid) return error;
  const std::size_t values = std::size_t(part.width) * part.height * 3;
  const double share = nA * nB / ((nA + nB) * (nA + nB));
  ExactSum sum;
  const auto total = [&](int half, std::size_t i) {
    sum.clear();
    addTerms(sum, part.terms[half], i);
    return sum.rounded();
  };
  std::vector<double> means(values), variances(values);
  for (std::size_t i = 0; i < values; ++i) {
    const double a = total(0, i), b = total(1, i), difference = a / nA - b / nB;
    means[i] = (a + b) / (nA + nB);
    variances[i] = difference * difference * share;
  }
  error.rmse = std::sqrt(std::accumulate(variances.begin(), variances.end(), 0.0) / double(values));
  error.relRmse = std::sqrt(meanRelativeSquare({part.width, part.height}, means, variances));
  return error;
}

}  // namespace steradian
