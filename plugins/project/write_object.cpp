// SPDX-License-Identifier: MIT
// An object -> its line of .srad text.
#include "keys.hpp"

namespace project {

namespace sdk = steradian::sdk;
using sdk::ObjectKind;

namespace {

void putLight(Keys& keys, const sdk::ObjectRecord& o, const sdk::ObjectRecord& usual) {
  keys.put("color", o.color, usual.color);
  keys.put("intensity", o.intensity, usual.intensity);
  keys.put("temperature", o.temperature, usual.temperature);
  if (o.kind == ObjectKind::spotLight) {
    keys.put("innerConeAngle", o.innerConeAngle, usual.innerConeAngle);
    keys.put("outerConeAngle", o.outerConeAngle, usual.outerConeAngle);
  }
  if (o.kind == ObjectKind::directionalLight)
    keys.put("angularDiameter", o.angularDiameter, usual.angularDiameter);
  if (o.kind == ObjectKind::sphereLight || o.kind == ObjectKind::diskLight)
    keys.put("radius", o.radius, usual.radius);
  if (o.kind == ObjectKind::rectLight) keys.put("size", o.dimensions, usual.dimensions, 2);
  if (o.kind != ObjectKind::environmentLight) return;
  keys.put("horizon", o.horizon, usual.horizon);
  keys.put("ground", o.ground, usual.ground);
  keys.putText("file", o.imageFile);
}

void putCamera(Keys& keys, const sdk::ObjectRecord& o, const sdk::ObjectRecord& usual) {
  keys.put("fovY", o.fovY, usual.fovY);
  if (o.projection != usual.projection) keys.json["projection"] = kProjections[o.projection];
  keys.put("orthographicHeight", o.orthographicHeight, usual.orthographicHeight);
  keys.put("fNumber", o.fNumber, usual.fNumber);
  keys.put("focusDistance", o.focusDistance, usual.focusDistance);
}

OrderedJson contentJson(const sdk::ObjectRecord& o) {
  const sdk::ObjectRecord usual = usualOf(o.kind);
  Keys keys;
  switch (o.kind) {
    case ObjectKind::group:
    case ObjectKind::plane:
      break;
    case ObjectKind::sphere:
    case ObjectKind::disk:
      keys.put("radius", o.radius, usual.radius);
      break;
    case ObjectKind::box:
      keys.put("size", o.dimensions, usual.dimensions);
      break;
    case ObjectKind::rect:
      keys.put("size", o.dimensions, usual.dimensions, 2);
      break;
    case ObjectKind::cylinder:
      keys.put("radius", o.radius, usual.radius);
      keys.put("height", o.height, usual.height);
      break;
    case ObjectKind::pointLight:
    case ObjectKind::spotLight:
    case ObjectKind::directionalLight:
    case ObjectKind::sphereLight:
    case ObjectKind::rectLight:
    case ObjectKind::diskLight:
    case ObjectKind::environmentLight:
      putLight(keys, o, usual);
      break;
    case ObjectKind::camera:
      putCamera(keys, o, usual);
      break;
    case ObjectKind::mesh:
      keys.json["id"] = o.mesh;
      break;
  }
  return keys.json;
}

}  // namespace

OrderedJson objectJson(sdk::Host& host, const sdk::ObjectRecord& o) {
  const sdk::ObjectRecord usual;
  Keys keys;
  keys.json["id"] = o.id;
  keys.putText("name", o.name);
  keys.putWhole("parent", o.parent, 0);
  keys.put("translation", o.translation, usual.translation);
  keys.put("rotation", o.rotation, usual.rotation);
  keys.put("scale", o.scale, usual.scale);
  keys.putFlag("visible", o.visible, 1);
  if (o.kind != ObjectKind::group) keys.json[kContents[std::uint32_t(o.kind)]] = contentJson(o);
  keys.putWhole("material", o.material, 0);
  addExtras(host, keys.json, o.extras,
            {"id",
             "name",
             "parent",
             "translation",
             "rotation",
             "scale",
             "visible",
             "material",
             "sphere",
             "plane",
             "box",
             "rect",
             "disk",
             "cylinder",
             "pointLight",
             "spotLight",
             "directionalLight",
             "camera",
             "sphereLight",
             "rectLight",
             "diskLight",
             "environmentLight",
             "mesh"});
  return keys.json;
}

}  // namespace project
