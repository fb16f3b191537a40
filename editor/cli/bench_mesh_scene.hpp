// SPDX-License-Identifier: MIT
// The scene of the mesh bench and its rays: a dented ball over hills, all of it one mesh.
#pragma once
#include <vector>

#include "renderer/ray_caster.hpp"
#include "renderer/scene/mesh.hpp"

namespace steradian::bench {

/// About so many triangles, half of them in the ball.
Mesh benchMesh(std::size_t triangles);
Scene benchMeshScene(const std::shared_ptr<const Mesh>& mesh);

/// `side` x `side` camera rays in blocks of 8 x 8, as the tracer groups them.
std::vector<CastRay> benchPrimaryRays(int side);

struct SecondaryRays {
  std::vector<CastRay> shadow;   // to a lamp above
  std::vector<CastRay> diffuse;  // in a random direction about the normal
};
/// From what the primary rays hit, in their order.
SecondaryRays benchSecondaryRays(const std::vector<CastRay>& primary, const std::vector<CastHit>& hits,
                                 const Mesh& mesh, const MeshBvh& bvh);

}  // namespace steradian::bench
