// SPDX-License-Identifier: MIT
// Scene -> the rows and counts that shaders read (shaders/gpu_types.h): camera-relative, double until the
// last step.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/gpu_textures.hpp"
#include "renderer/mesh/bvh.hpp"
#include "renderer/mesh/vertex_rows.hpp"
#include "renderer/renderer.hpp"
#include "shaders/gpu_types.h"

namespace steradian {

/// Equal values but for the film's unit give equal radiance: the film starts over exactly when two differ.
struct GpuScene {
  std::vector<glm::vec4> rows;
  gpu::TraceParams params{};   // counts, table rows and settings; rows and samples of a dispatch left 0
  std::uint32_t features = 0;  // FEATURE_* bits that this scene needs
  glm::dvec3 origin{0.0};      // world position of the rows' origin (the camera)
  std::shared_ptr<const Image> environment;                    // whose tables the shaders read; null = none
  std::vector<std::shared_ptr<const MeshBvh>> meshes;          // what lies in the mesh buffer, in this order
  std::vector<std::shared_ptr<const VertexRows>> vertices;     // of these meshes
  std::vector<std::shared_ptr<const PackedTexture>> textures;  // what lies in the texel buffer, in this order
  bool meshLights = false;                                     // meshes are among the lights
  std::uint32_t solidLights = 0;                               // and solids: bit i of kind LIGHT_BOX + i
  double traversalSteps = 0.0;  // loop turns of the worst of some rays through the hierarchy over the scene
  float filmUnit = 1.0f;        // for the sums of a film that begins with this scene (film_unit.hpp)
  double traversals = 1.0;      // per ray; more where it may begin anew behind what is there only in part

  bool sameRadiance(const GpuScene& other) const;
  bool shapeHierarchy() const;  // bounded shapes lie in the hierarchy
  bool oneInstance() const;     // of a mesh, which needs no hierarchy above it
};

class SceneCache;

/// Invisible objects and shapes without extent are left out. The cache keeps what is heavy for the next call.
GpuScene packScene(const Scene& scene, const CameraView& view, Extent film, SceneCache& cache,
                   ShapeSearch search = ShapeSearch::automatic);
GpuScene packScene(const Scene& scene, const CameraView& view, Extent film,
                   ShapeSearch search = ShapeSearch::automatic);

}  // namespace steradian
