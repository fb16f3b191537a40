// SPDX-License-Identifier: MIT
// The rules of what objects hold: shapes, lights, cameras; and of materials.
#include "renderer/scene/validate_detail.hpp"

namespace steradian {

namespace {

constexpr double kPi = 3.141592653589793;
constexpr double kHalfPi = 1.5707965;  // the float nearest to pi/2 lies above it

/// 0 switches it off, else a range.
void zeroOrRange(Checker& check, const std::string& field, double value, double low, double high) {
  if (value == 0.0 || (value >= low && value <= high)) return;
  check.fail(field,
             "is " + text(value) + "; expected 0 (off) or a number from " + text(low) + " to " + text(high));
}

struct ShapeRules {
  Checker& check;
  void operator()(const Sphere& s) const { check.length("shape.radius", s.radius); }
  void operator()(const Plane&) const {}
  void operator()(const Box& s) const { check.each("shape.size", s.size, kSmallest, kLargest); }
  void operator()(const Rect& s) const { check.each("shape.size", s.size, kSmallest, kLargest); }
  void operator()(const Disk& s) const { check.length("shape.radius", s.radius); }
  void operator()(const Cylinder& s) const {
    check.length("shape.radius", s.radius);
    check.length("shape.height", s.height);
  }
  void operator()(const MeshShape& s) const {  // its vertices are checked once, where they come in
    if (!s.mesh) check.fail("shape.mesh", "is missing");
  }
};

struct LightRules {
  Checker& check;
  void operator()(const PointLight&) const {}
  void operator()(const SpotLight& spot) const {
    check.inside("light.outerConeAngle", spot.outerConeAngle, 0.0, kHalfPi);
    if (!(spot.innerConeAngle >= 0.0f && spot.innerConeAngle < spot.outerConeAngle))
      check.fail("light.innerConeAngle", "is " + text(spot.innerConeAngle) +
                                             "; expected at least 0 and less than outerConeAngle, " +
                                             text(spot.outerConeAngle));
  }
  void operator()(const DirectionalLight& sun) const {
    check.range("light.angularDiameter", sun.angularDiameter, 0.0, kHalfPi);
  }
  void operator()(const SphereLight& light) const { check.length("light.radius", light.radius); }
  void operator()(const RectLight& light) const { check.each("light.size", light.size, kSmallest, kLargest); }
  void operator()(const DiskLight& light) const { check.length("light.radius", light.radius); }
  void operator()(const EnvironmentLight& sky) const {
    check.each("light.horizon", sky.horizon, 0.0, kBrightest);
    check.each("light.ground", sky.ground, 0.0, kBrightest);
    // Its pixels are checked once, where they are read.
    if (sky.image && (sky.image->channels != 3 || sky.image->width < 1 || sky.image->height < 1))
      check.fail("light.image", "has " + std::to_string(sky.image->width) + "x" +
                                    std::to_string(sky.image->height) + " pixels of " +
                                    std::to_string(sky.image->channels) + " channels; expected 3 channels");
  }
};

void checkSlot(Checker& check, const std::string& field, const TextureSlot& slot) {
  check.each(field + ".transformX", slot.transformX, -1e6, 1e6);
  check.each(field + ".transformY", slot.transformY, -1e6, 1e6);
}

struct ContentRules {
  Checker& check;
  const std::unordered_set<Id>& materials;
  void operator()(const Group&) const {}
  void operator()(const Camera& camera) const {
    check.inside("camera.fovY", camera.fovY, 0.0, kPi);
    check.length("camera.orthographicHeight", camera.orthographicHeight);
    zeroOrRange(check, "camera.fNumber", camera.fNumber, kSmallest, kLargest);
    check.length("camera.focusDistance", camera.focusDistance);
  }
  void operator()(const Geometry& geometry) const {
    std::visit(ShapeRules{check}, geometry.shape);
    if (geometry.material != Id::none && !materials.count(geometry.material))
      check.fail("material",
                 "is " + std::to_string(unsigned(geometry.material)) + "; there is no such material");
  }
  void operator()(const Light& light) const {
    check.each("light.color", light.color, 0.0, kBrightest);
    check.range("light.intensity", light.intensity, 0.0, kBrightest);
    zeroOrRange(check, "light.temperature", light.temperature, 1000.0, 40000.0);
    std::visit(LightRules{check}, light.kind);
  }
};

}  // namespace

void checkContent(Checker& check, const Object& object, const std::unordered_set<Id>& materials) {
  std::visit(ContentRules{check, materials}, object.content);
}

void checkMaterial(Checker& check, const Material& material) {
  check.at(place(material));
  check.each("albedo", material.albedo, 0.0, 1.0);
  check.range("metallic", material.metallic, 0.0, 1.0);
  check.range("roughness", material.roughness, 0.0, 1.0);
  check.range("specular", material.specular, 0.0, 1.0);
  check.range("ior", material.ior, 1.0, 1000.0);
  check.each("emissionColor", material.emissionColor, 0.0, kBrightest);
  check.range("emissionLuminance", material.emissionLuminance, 0.0, kBrightest);
  check.range("transmission", material.transmission, 0.0, 1.0);
  for (int i = 0; i < 3; ++i)
    check.above(std::string("attenuationColor.") + "xyz"[i], material.attenuationColor[i], 0.0, 1.0);
  zeroOrRange(check, "attenuationDistance", material.attenuationDistance, kSmallest, kLargest);
  check.range("clearcoat", material.clearcoat, 0.0, 1.0);
  check.range("clearcoatRoughness", material.clearcoatRoughness, 0.0, 1.0);
  check.each("edgeTint", material.edgeTint, 0.0, 1.0);
  check.range("normalScale", material.normalScale, 0.0, 100.0);
  check.range("opacity", material.opacity, 0.0, 1.0);
  check.range("alphaCutoff", material.alphaCutoff, 0.0, 1.0);
  checkSlot(check, "albedoTexture", material.albedoTexture);
  checkSlot(check, "metallicRoughnessTexture", material.metallicRoughnessTexture);
  checkSlot(check, "normalTexture", material.normalTexture);
  checkSlot(check, "emissionTexture", material.emissionTexture);
}

}  // namespace steradian
