// SPDX-License-Identifier: MIT
// One element of "objects" -> a record.
#include <algorithm>

#include "texts.hpp"

namespace project {

namespace sdk = steradian::sdk;
using sdk::ObjectKind;

namespace {

void readLight(Fields& f, sdk::ObjectRecord& out, Texts& texts) {
  f.read("color", out.color, kNotNegative);
  f.read("intensity", out.intensity, kNotNegative);
  f.read("temperature", out.temperature, kNotNegative);
  if (out.kind == ObjectKind::spotLight) {
    f.read("innerConeAngle", out.innerConeAngle, kNotNegative);
    f.read("outerConeAngle", out.outerConeAngle, kPositive);
  }
  if (out.kind == ObjectKind::directionalLight) f.read("angularDiameter", out.angularDiameter, kNotNegative);
  if (out.kind == ObjectKind::sphereLight || out.kind == ObjectKind::diskLight)
    f.read("radius", out.radius, kPositive);
  if (out.kind == ObjectKind::rectLight) f.read("size", std::span(out.dimensions, 2), kPositive);
  if (out.kind != ObjectKind::environmentLight) return;
  f.read("horizon", out.horizon, kNotNegative);
  f.read("ground", out.ground, kNotNegative);
  out.imageFile = texts.read(f, "file");
}

void readCamera(Fields& f, sdk::ObjectRecord& out) {
  f.read("fovY", out.fovY, kPositive);
  f.readChoice("projection", out.projection, kProjections);
  f.read("orthographicHeight", out.orthographicHeight, kPositive);
  f.read("fNumber", out.fNumber, kNotNegative);
  f.read("focusDistance", out.focusDistance, kPositive);
}

void readContent(Fields f, sdk::ObjectRecord& out, Texts& texts) {
  out.radius = usualOf(out.kind).radius;
  std::ranges::copy(usualOf(out.kind).dimensions, out.dimensions);
  switch (out.kind) {
    case ObjectKind::group:
    case ObjectKind::plane:
      break;
    case ObjectKind::sphere:
    case ObjectKind::disk:
      f.read("radius", out.radius, kPositive);
      break;
    case ObjectKind::box:
      f.read("size", out.dimensions, kPositive);
      break;
    case ObjectKind::rect:
      f.read("size", std::span(out.dimensions, 2), kPositive);
      break;
    case ObjectKind::cylinder:
      f.read("radius", out.radius, kPositive);
      f.read("height", out.height, kPositive);
      break;
    case ObjectKind::pointLight:
    case ObjectKind::spotLight:
    case ObjectKind::directionalLight:
    case ObjectKind::sphereLight:
    case ObjectKind::rectLight:
    case ObjectKind::diskLight:
    case ObjectKind::environmentLight:
      readLight(f, out, texts);
      break;
    case ObjectKind::camera:
      readCamera(f, out);
      break;
    case ObjectKind::mesh:
      if (!f.has("id")) f.fail("id", "the id of an element of \"meshes\"");
      f.readUnsigned("id", out.mesh, 1);
      break;
  }
}

bool isShape(ObjectKind kind) {
  return (kind >= ObjectKind::sphere && kind <= ObjectKind::cylinder) || kind == ObjectKind::mesh;
}

}  // namespace

sdk::ObjectRecord readObject(Fields& f, Texts& texts) {
  sdk::ObjectRecord out;
  f.readUnsigned("id", out.id, 1);
  out.name = texts.read(f, "name");
  f.readUnsigned("parent", out.parent);
  f.read("translation", out.translation);
  f.read("rotation", out.rotation);
  f.read("scale", out.scale);
  f.readFlag("visible", out.visible);
  for (std::uint32_t kind = 1; kind < std::size(kContents); ++kind) {
    if (!f.has(kContents[kind])) continue;
    if (out.kind != ObjectKind::group)
      throw sdk::BadInput(f.path() + ": expected one content, got both \"" +
                          kContents[std::uint32_t(out.kind)] + "\" and \"" + kContents[kind] + "\"");
    out.kind = ObjectKind{kind};
    f.within(kContents[kind], [&](Fields inner) { readContent(inner, out, texts); });
  }
  if (f.has("material") && !isShape(out.kind)) f.fail("material", "it only on an object with a shape");
  f.readUnsigned("material", out.material);
  out.extras = texts.keep(f.leftover());
  return out;
}

}  // namespace project
