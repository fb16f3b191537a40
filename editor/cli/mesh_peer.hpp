// SPDX-License-Identifier: MIT
// What the module with Embree (tests/peers/embree_caster.cpp) offers the bench. Plain C, loaded at run time.
#pragma once
#include <cstddef>
#include <cstdint>

extern "C" {

struct MeshPeer;  // a built mesh

/// Triangles as indices into 3 floats per position. Seconds of the build go to *seconds.
using MeshPeerBuild = MeshPeer*(const float* positions, std::size_t positionCount,
                                const std::uint32_t* triangles, std::size_t triangleCount, unsigned threads,
                                double* seconds);
/// 8 floats per ray: origin, longest distance, direction, -. Writes one distance per ray (infinity = nothing;
/// any rays: 0 = something). Returns seconds.
using MeshPeerCast = double(MeshPeer* peer, const float* rays, std::size_t count, int any, unsigned threads,
                            float* distances);
using MeshPeerFree = void(MeshPeer* peer);
}
