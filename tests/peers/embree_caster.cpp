// SPDX-License-Identifier: MIT
// Embree as a peer of the mesh bench: single rays (rtcIntersect1, rtcOccluded1) on some threads.
#include <embree3/rtcore.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "editor/cli/mesh_peer.hpp"

struct MeshPeer {
  RTCDevice device;
  RTCScene scene;
};

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

RTCRay rayOf(const float* r) {
  RTCRay ray{};
  ray.org_x = r[0], ray.org_y = r[1], ray.org_z = r[2], ray.tfar = r[3];
  ray.dir_x = r[4], ray.dir_y = r[5], ray.dir_z = r[6];
  ray.mask = ~0u;
  return ray;
}

float closest(RTCScene scene, const float* ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit hit{};
  hit.ray = rayOf(ray);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &hit);
  return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : hit.ray.tfar;
}

float any(RTCScene scene, const float* ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay r = rayOf(ray);
  rtcOccluded1(scene, &context, &r);
  return r.tfar < 0.0f ? 0.0f : std::numeric_limits<float>::infinity();
}

}  // namespace

extern "C" [[gnu::visibility("default")]] MeshPeer* steradianPeerBuild(const float* positions,
                                                                       std::size_t positionCount,
                                                                       const std::uint32_t* triangles,
                                                                       std::size_t triangleCount,
                                                                       unsigned threads, double* seconds) {
  const std::string config = "threads=" + std::to_string(threads);
  auto* peer = new MeshPeer{rtcNewDevice(config.c_str()), nullptr};
  const auto start = Clock::now();
  peer->scene = rtcNewScene(peer->device);
  rtcSetSceneFlags(peer->scene, RTC_SCENE_FLAG_ROBUST);  // watertight, as ours is
  RTCGeometry mesh = rtcNewGeometry(peer->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* p = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, positionCount);
  void* t = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangleCount);
  std::memcpy(p, positions, positionCount * 12);
  std::memcpy(t, triangles, triangleCount * 12);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(peer->scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(peer->scene);
  *seconds = secondsSince(start);
  return peer;
}

extern "C" [[gnu::visibility("default")]] double steradianPeerCast(MeshPeer* peer, const float* rays,
                                                                   std::size_t count, int anyHit,
                                                                   unsigned threads, float* distances) {
  const auto start = Clock::now();
  std::vector<std::thread> workers;
  constexpr std::size_t block = 4096;
  for (unsigned worker = 0; worker < threads; ++worker)
    workers.emplace_back([=] {
      for (std::size_t begin = worker * block; begin < count; begin += threads * block)
        for (std::size_t i = begin; i < std::min(count, begin + block); ++i)
          distances[i] = anyHit != 0 ? any(peer->scene, rays + 8 * i) : closest(peer->scene, rays + 8 * i);
    });
  for (std::thread& worker : workers) worker.join();
  return secondsSince(start);
}

extern "C" [[gnu::visibility("default")]] void steradianPeerFree(MeshPeer* peer) {
  rtcReleaseScene(peer->scene);
  rtcReleaseDevice(peer->device);
  delete peer;
}
