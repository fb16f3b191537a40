// SPDX-License-Identifier: MIT
#include "editor/cli/bench_mesh.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include "editor/cli/bench_mesh_scene.hpp"
#include "editor/cli/mesh_peer.hpp"
#include "renderer/gpu_meshes.hpp"
#include "renderer/ray_caster.hpp"
#include "renderer/stopwatch.hpp"

namespace steradian::bench {

namespace {

namespace fs = std::filesystem;

/// The module beside this program, if there is one.
struct Peer {
  MeshPeerBuild* build = nullptr;
  MeshPeerCast* cast = nullptr;
  MeshPeerFree* free = nullptr;
  std::string missing;

  Peer() {
    std::error_code none;
    const fs::path module = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path() / "lib" /
                            "steradian" / "embree_caster.so";
    void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library) {
      build = reinterpret_cast<MeshPeerBuild*>(dlsym(library, "steradianPeerBuild"));
      cast = reinterpret_cast<MeshPeerCast*>(dlsym(library, "steradianPeerCast"));
      free = reinterpret_cast<MeshPeerFree*>(dlsym(library, "steradianPeerFree"));
    }
    if (!build || !cast || !free)
      missing = "no Embree beside: " + module.string() + " is not there; build the tests with libembree-dev";
  }
};

struct PeerMesh {
  const Peer& peer;
  MeshPeer* mesh = nullptr;
  double buildSeconds = 0.0;

  PeerMesh(const Peer& loaded, const Mesh& source, unsigned threads) : peer(loaded) {
    if (peer.missing.empty())
      mesh = peer.build(&source.positions[0].x, source.positions.size(), &source.triangles[0].x,
                        source.triangles.size(), threads, &buildSeconds);
  }
  ~PeerMesh() {
    if (mesh) peer.free(mesh);
  }
  PeerMesh(const PeerMesh&) = delete;
};

bool differs(const CastHit& ours, float theirs, bool any) {
  const bool hit = ours.primitive != gpu::NO_PRIMITIVE, theirHit = theirs < 1e29f;
  if (hit != theirHit) return true;
  return hit && !any &&
         std::abs(ours.t - theirs) > 1e-4f * theirs + 1e-5f;  // some metres are rounded to 1e-6
}

double meanVisits(const MeshBvh& bvh, const std::vector<CastRay>& rays, const std::vector<CastHit>& hits) {
  const std::size_t step = rays.size() / 4096 + 1;  // enough for two digits
  double sum = 0.0;
  for (std::size_t i = 0; i < rays.size(); i += step)
    sum += visitsBefore(bvh, rays[i].o, rays[i].d, hits[i].t);
  return sum * double(step) / double(rays.size());
}

MeshRays measure(RayCaster& caster, const PeerMesh& peer, const std::vector<CastRay>& rays, const char* kind,
                 bool any, const MeshBenchOptions& options, std::vector<CastHit>* hits) {
  MeshRays out{kind, rays.size()};
  double theirs = 0.0;
  std::vector<float> distances(rays.size());
  RayCaster::Answer answer;
  double ours = std::numeric_limits<double>::infinity();
  theirs = ours;
  if (options.warmUpMs > 0.0) {
    // Dispatches without a gap: while rays are copied, the device would fall asleep again.
    const double once = std::max(0.02, caster.cast(rays, any).milliseconds);
    caster.cast(rays, any, int(options.warmUpMs / once) + 1);
  }
  // Interleaved, so that a busy machine treats both alike
  for (int run = 0; run < options.runs; ++run) {
    answer = caster.cast(rays, any);
    ours = std::min(ours, answer.milliseconds * 1e-3);
    if (peer.mesh)
      theirs = std::min(theirs, peer.peer.cast(peer.mesh, &rays[0].o.x, rays.size(), any, options.threads,
                                               distances.data()));
  }
  out.mraysPerSecond = double(rays.size()) / ours * 1e-6;
  if (peer.mesh) {
    out.embree = double(rays.size()) / theirs * 1e-6;
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) different += differs(answer.hits[i], distances[i], any);
    out.disagreeing = double(different) / double(rays.size());
  }
  if (hits) *hits = std::move(answer.hits);
  return out;
}

MeshBenchResult measureSize(const std::shared_ptr<gpu::Device>& device, const Peer& peer,
                            std::size_t triangles, const MeshBenchOptions& options) {
  const std::shared_ptr<const Mesh> mesh = sharedMesh(benchMesh(triangles));
  MeshBenchResult result;
  result.triangles = mesh->triangles.size();
  const auto start = std::chrono::steady_clock::now();
  const MeshBvh built = buildBvh(mesh->positions, mesh->triangles, options.threads);
  result.buildSeconds = secondsSince(start);
  result.depth = built.depth;
  result.steps = built.steps;
  result.megabytes = ((built.nodes.size() + built.triangles.size()) * sizeof(glm::vec4)) >> 20;
  const PeerMesh peerMesh(peer, *mesh, options.threads);
  if (peerMesh.mesh) result.embreeBuildSeconds = peerMesh.buildSeconds;

  GpuScene scene = packScene(benchMeshScene(mesh), {}, {64, 64});
  const GpuScene& packed = scene;
  const std::shared_ptr<const MeshBvh> bvh = packed.meshes[0];
  const bool cpu = describe(*device).type == "CPU";
  RayCaster caster(device, std::move(scene), options.whileWhile.value_or(cpu));
  MeshBenchOptions own = options;
  if (cpu) own.warmUpMs = 0.0;
  const int side = options.side != 0 ? options.side : cpu ? 512 : 2048;
  const std::vector<CastRay> primary = benchPrimaryRays(side);
  std::vector<CastHit> hits;
  result.rays.push_back(measure(caster, peerMesh, primary, "primary", false, own, &hits));
  result.rays.back().visits = meanVisits(*bvh, primary, hits);
  const SecondaryRays next = benchSecondaryRays(primary, hits, *mesh, *bvh);
  result.rays.push_back(measure(caster, peerMesh, next.shadow, "shadow", true, own, nullptr));
  result.rays.push_back(measure(caster, peerMesh, next.diffuse, "diffuse", false, own, &hits));
  result.rays.back().visits = meanVisits(*bvh, next.diffuse, hits);
  return result;
}

}  // namespace

MeshBench measureMeshes(const MeshBenchOptions& options) {
  const auto device = openDevice({.device = options.device});
  const Peer peer;
  MeshBench bench{describe(*device), {}, peer.missing};
  for (const std::size_t triangles : options.triangles)
    bench.results.push_back(measureSize(device, peer, triangles, options));
  return bench;
}

}  // namespace steradian::bench
