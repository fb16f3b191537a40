// SPDX-License-Identifier: MIT
// Cameras, and KHR_lights_punctual.
#include <algorithm>
#include <cmath>

#include "kept.hpp"
#include "scene_writer.hpp"

namespace gltf {

void SceneWriter::readCamera(const tinygltf::Camera& camera, Content& out) {
  out.record.kind = sdk::ObjectKind::camera;
  out.name = camera.name;
  Json kept = keptOf(camera);
  if (!camera.name.empty()) kept["name"] = camera.name;
  double aspect = 0;
  if (camera.type == "perspective") {
    const auto& p = camera.perspective;
    out.record.fovY = p.yfov;
    aspect = p.aspectRatio;
    kept["znear"] = p.znear;
    if (p.zfar > 0) kept["zfar"] = p.zfar;
  } else {
    const auto& o = camera.orthographic;
    if (o.ymag == 0 || o.xmag == 0) throw sdk::BadInput("xmag and ymag: expected numbers that are not 0");
    out.record.projection = 1;
    out.record.orthographicHeight = std::max(1e-12, 2 * std::abs(o.ymag));
    aspect = std::abs(o.xmag / o.ymag);
    kept["znear"] = o.znear;
    kept["zfar"] = o.zfar;
  }
  if (aspect > 0) kept["aspectRatio"] = aspect;
  if (aspectRatio_ == 0) aspectRatio_ = aspect;
  out.kept["camera"] = kept;
}

void SceneWriter::readLight(const tinygltf::Light& light, const std::string& name, Content& out) {
  constexpr double kWidest = 1.5707;
  sdk::ObjectRecord& record = out.record;
  record.kind = light.type == "spot"          ? sdk::ObjectKind::spotLight
                : light.type == "directional" ? sdk::ObjectKind::directionalLight
                                              : sdk::ObjectKind::pointLight;
  out.name = light.name;
  record.intensity = float(light.intensity);
  for (std::size_t i = 0; i < light.color.size() && i < 3; ++i) record.color[i] = float(light.color[i]);
  if (record.kind == sdk::ObjectKind::spotLight) {
    const double outer = std::clamp(light.spot.outerConeAngle, 1e-4, kWidest);
    record.outerConeAngle = float(outer);
    record.innerConeAngle = float(std::clamp(light.spot.innerConeAngle, 0.0, outer * 0.999));
  }
  Json kept = keptOf(light);
  if (!light.name.empty()) kept["name"] = light.name;
  if (light.range > 0) {
    kept["range"] = light.range;
    report_.dropped("light of '" + name + "', range", "its light falls off with the square of the distance");
  }
  if (!kept.empty()) out.kept["light"] = kept;
}

}  // namespace gltf
