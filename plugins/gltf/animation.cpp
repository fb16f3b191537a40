// SPDX-License-Identifier: MIT
// Animations: tracks for the scene, and the pose at one time for what is baked.
#include "animation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "views.hpp"

namespace gltf {

namespace {

constexpr int kStepsPerCubic = 8;

glm::dquat quaternion(const std::vector<double>& v) {
  const glm::dquat q(v[3], v[0], v[1], v[2]);
  const double length = glm::length(q);
  return length > 1e-12 ? q / length : glm::dquat(1, 0, 0, 0);
}

std::vector<double> numbers(const glm::dquat& q) {
  return {q.x, q.y, q.z, q.w};
}

bool pathOf(const std::string& name, Path& path) {
  static constexpr const char* kNames[] = {"translation", "rotation", "scale", "weights"};
  const auto found = std::find(std::begin(kNames), std::end(kNames), name);
  if (found == std::end(kNames)) return false;
  path = Path(found - std::begin(kNames));
  return true;
}

void readKeys(const Document& document, const tinygltf::AnimationSampler& sampler, const std::string& place,
              Track& track) {
  const Numbers times = readNumbers(document, sampler.input, {"key times", 1, 1});
  demandFinite(times, sampler.input, "key times");
  for (std::size_t i = 1; i < times.values.size(); ++i)
    if (!(times.values[i] > times.values[i - 1]))
      throw sdk::BadInput(place + ".input: expected increasing times, got " +
                          std::to_string(times.values[i]) + " in key " + std::to_string(i) + " after " +
                          std::to_string(times.values[i - 1]));
  track.interpolation = sampler.interpolation == "STEP"          ? Interpolation::step
                        : sampler.interpolation == "CUBICSPLINE" ? Interpolation::cubic
                                                                 : Interpolation::linear;
  const bool weights = track.path == Path::weights;
  const int size = weights ? 1 : track.path == Path::rotation ? 4 : 3;
  const Numbers values = readNumbers(document, sampler.output, {"key values", size, size});
  demandFinite(values, sampler.output, "key values");
  const std::size_t perKey = track.interpolation == Interpolation::cubic ? 3 : 1;
  const std::size_t keys = times.values.size() * perKey;
  if (keys == 0 || values.count() % keys != 0 || (!weights && values.count() != keys))
    throw sdk::BadInput(place + ".output: expected " + std::to_string(keys) + " values, got " +
                        std::to_string(values.count()));
  track.components = weights ? int(values.count() / keys) : size;
  track.times = times.values;
  track.values = values.values;
}

/// False when the channel moves nothing that is known here.
bool readTrack(const Document& document, const tinygltf::Animation& animation, std::size_t a, std::size_t c,
               Track& track) {
  const std::string place = at("animations", a);
  document.demand(at(place + ".channels", c));
  const tinygltf::AnimationChannel& channel = animation.channels[c];
  if (channel.target_node < 0 || !pathOf(channel.target_path, track.path)) return false;
  track.node = std::size_t(channel.target_node);
  if (std::size_t(channel.sampler) >= animation.samplers.size())
    throw sdk::BadInput(at(place + ".channels", c) + ".sampler: expected an index below " +
                        std::to_string(animation.samplers.size()) + ", got " +
                        std::to_string(channel.sampler));
  const std::string samplerPlace = at(place + ".samplers", std::size_t(channel.sampler));
  document.demand(samplerPlace);
  readKeys(document, animation.samplers[std::size_t(channel.sampler)], samplerPlace, track);
  return true;
}

void addKeys(const Track& track, std::vector<sdk::Key>& keys) {
  const auto add = [&](double time) {
    sdk::Key& key = keys.emplace_back();
    key.time = time;
    std::vector<double> value = track.at(time);
    if (track.path == Path::scale) {
      const glm::dvec3 scale = awayFromZero({value[0], value[1], value[2]});
      value = {scale.x, scale.y, scale.z};
    }
    std::transform(value.begin(), value.end(), key.value,
                   [](double v) { return std::clamp(v, -1e12, 1e12); });  // splines overshoot
  };
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    add(track.times[i]);
    if (track.interpolation != Interpolation::cubic || i + 1 == track.times.size()) continue;
    for (int step = 1; step < kStepsPerCubic; ++step) {
      const double time =
          glm::mix(double(track.times[i]), double(track.times[i + 1]), step / double(kStepsPerCubic));
      if (time > keys.back().time && time < track.times[i + 1]) add(time);
    }
  }
}

}  // namespace

std::vector<double> Track::at(double time) const {
  const bool cubic = interpolation == Interpolation::cubic;
  const auto n = std::size_t(components);
  // Part 0 = in-tangent, 1 = value, 2 = out-tangent of a key.
  const auto part = [&](std::size_t key, std::size_t which) {
    const auto from = values.begin() + std::ptrdiff_t((cubic ? key * 3 + which : key) * n);
    return std::vector<double>(from, from + std::ptrdiff_t(n));
  };
  const auto unitOf = [&](std::vector<double> v) {
    return path == Path::rotation ? numbers(quaternion(v)) : v;
  };
  if (!(time > times.front())) return unitOf(part(0, 1));
  if (time >= times.back()) return unitOf(part(times.size() - 1, 1));
  const auto i = std::size_t(std::upper_bound(times.begin(), times.end(), time) - times.begin()) - 1;
  if (time == times[i] || interpolation == Interpolation::step) return unitOf(part(i, 1));
  const double span = double(times[i + 1]) - times[i], u = (time - times[i]) / span;
  std::vector<double> a = part(i, 1), b = part(i + 1, 1);
  if (!cubic && path == Path::rotation) return numbers(glm::slerp(quaternion(a), quaternion(b), u));
  std::vector<double> out(n);
  for (std::size_t c = 0; c < n && !cubic; ++c) out[c] = glm::mix(a[c], b[c], u);
  if (!cubic) return out;
  // glTF 2.0, appendix C.5: a cubic Hermite segment.
  const std::vector<double> leaving = part(i, 2), arriving = part(i + 1, 0);
  const double u2 = u * u, u3 = u2 * u;
  for (std::size_t c = 0; c < n; ++c)
    out[c] = (2 * u3 - 3 * u2 + 1) * a[c] + span * (u3 - 2 * u2 + u) * leaving[c] + (3 * u2 - 2 * u3) * b[c] +
             span * (u3 - u2) * arriving[c];
  return unitOf(out);
}

std::vector<Track> readTracks(const Document& document, int chosen, Report& report) {
  std::vector<Track> out;
  const auto& animations = document.model.animations;
  if (chosen >= int(animations.size()))
    throw sdk::BadInput("has " + std::to_string(animations.size()) + " animations; there is no animation " +
                        std::to_string(chosen));
  std::set<std::pair<std::size_t, Path>> moved;
  for (std::size_t a = 0; a < animations.size(); ++a) {
    if (chosen >= 0 && int(a) != chosen) continue;
    const std::string name = named("animation", animations[a].name, a);
    std::size_t hidden = 0, unknown = 0;
    for (std::size_t c = 0; c < animations[a].channels.size(); ++c)
      report.attempt(name + ", channel " + std::to_string(c), [&] {
        Track track;
        if (!readTrack(document, animations[a], a, c, track))
          ++unknown;
        else if (!moved.insert({track.node, track.path}).second)
          ++hidden;
        else
          out.push_back(std::move(track));
      });
    if (unknown) report.dropped(name, std::to_string(unknown) + " channels move what is no node's transform");
    if (hidden)
      report.dropped(name, std::to_string(hidden) +
                               " channels move what an earlier animation moves; the parameter "
                               "animation = " +
                               std::to_string(a) + " chooses this one alone");
  }
  return out;
}

void addChannels(const std::vector<Track>& tracks, const std::vector<std::uint32_t>& objectOf,
                 const Document& document, Report& report, sdk::SceneSink& sink) {
  bool resampled = false;
  for (const Track& track : tracks) {
    if (objectOf[track.node] == 0 || track.path == Path::weights) continue;
    const std::string name = named("node", document.model.nodes[track.node].name, track.node);
    report.attempt("animation of " + name, [&] {
      std::vector<sdk::Key> keys;
      addKeys(track, keys);
      resampled = resampled || track.interpolation == Interpolation::cubic;
      sink.addChannel({.target = objectOf[track.node],
                       .property = std::uint32_t(track.path),
                       .interpolation = track.interpolation == Interpolation::step ? 0u : 1u,
                       .keys = keys.data(),
                       .keyCount = keys.size()});
    });
  }
  if (resampled)
    report.approximated("animation, cubic splines",
                        std::to_string(kStepsPerCubic) + " straight pieces between two keys");
}

Pose poseAt(const Document& document, const std::vector<Track>& tracks, double time) {
  const auto& nodes = document.model.nodes;
  std::vector<Trs> local(nodes.size());
  std::vector<bool> moved(nodes.size(), false);
  Pose pose{std::vector<glm::dmat4>(nodes.size()), std::vector<std::vector<double>>(nodes.size())};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    bool sheared;
    local[n] = trsOf(nodes[n], sheared);
    pose.weights[n] = nodes[n].weights;
  }
  for (const Track& track : tracks) {
    const std::vector<double> v = track.at(time);
    Trs& trs = local[track.node];
    if (track.path == Path::weights) pose.weights[track.node] = v;
    if (track.path == Path::translation) trs.translation = {v[0], v[1], v[2]};
    if (track.path == Path::rotation) trs.rotation = quaternion(v);
    if (track.path == Path::scale) trs.scale = {v[0], v[1], v[2]};
    moved[track.node] = moved[track.node] || track.path != Path::weights;
  }
  for (std::size_t n = 0; n < nodes.size(); ++n)
    pose.world[n] = moved[n] ? matrixOf(local[n]) : matrixOf(nodes[n]);
  std::vector<bool> child(nodes.size(), false);
  for (const auto& node : nodes)
    for (const int c : node.children) child[std::size_t(c)] = true;
  std::vector<std::size_t> open;  // parents before children
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (!child[n]) open.push_back(n);
  while (!open.empty()) {
    const std::size_t n = open.back();
    open.pop_back();
    for (const int c : nodes[n].children) {
      pose.world[std::size_t(c)] = pose.world[n] * pose.world[std::size_t(c)];
      open.push_back(std::size_t(c));
    }
  }
  return pose;
}

}  // namespace gltf
