// SPDX-License-Identifier: MIT
// What the oracle traces: the scene flattened to double, one record per thing that a ray can meet.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include "renderer/scene/scene.hpp"
#include "tests/oracle/microfacet.hpp"

namespace steradian::oracle {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

/// A material and the albedo tables that energy compensation needs; null when it is off.
struct Finish {
  Material material;
  std::shared_ptr<const AlbedoTable> base, coat;
};

/// A surface: an object's, or that of an area light (black, `finish` null).
struct Body {
  Shape shape;
  dmat4 objectFromWorld{1.0};
  const Finish* finish = nullptr;
  dvec3 emission{0.0};    // nit
  bool oneSided = false;  // emits from the normal's side alone

  bool solid() const;  // has an inside
};

/// A light that no ray can hit: point and spot (cd), or parallel light (lx).
struct PunctualLight {
  dvec3 position{0.0}, axis{0.0};  // world; axis = where it shines
  dvec3 intensity{0.0};
  bool parallel = false;
  double cosInner = -1.0, cosOuter = -2.0;
};

/// Parallel light of an angular size: a disc in the sky of even radiance E / (pi sin^2(half angle)), so that
/// a surface that faces its centre receives the light's illuminance E.
struct SunDisc {
  dvec3 towards{0.0};
  double cosHalf = 1.0;
  dvec3 radiance{0.0};
};

struct Sky {
  dmat3 localFromWorld{1.0};
  EnvironmentLight light;
  dvec3 scale{0.0};

  /// Nit, from a unit direction in the world.
  dvec3 radiance(const dvec3& direction) const;
};

struct World {
  std::vector<Body> bodies;
  std::vector<PunctualLight> punctual;
  std::vector<SunDisc> suns;
  std::unique_ptr<Sky> sky;  // null = black
  std::map<Id, Finish> finishes;
  bool compensate = false;

  explicit World(const Scene& scene);
  World(const World&) = delete;

  /// What a ray that leaves the scene sees.
  dvec3 background(const dvec3& direction) const;

 private:
  void add(const Light& light, const dmat4& worldFromObject);
  const Finish* finishOf(const Scene& scene, Id material);
};

}  // namespace steradian::oracle
