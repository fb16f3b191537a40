// SPDX-License-Identifier: MIT
#include "tests/oracle/path.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "tests/oracle/bsdf.hpp"
#include "tests/oracle/surface.hpp"

namespace steradian::oracle {
namespace {

/// A frame at a hit whose z is the normal on the side that the ray came from.
struct Frame {
  dvec3 x, y, z;

  explicit Frame(const dvec3& normal) : z(normal) {
    const dvec3 other = std::abs(z.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    x = glm::normalize(glm::cross(other, z));
    y = glm::cross(z, x);
  }
  dvec3 local(const dvec3& v) const { return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)}; }
  dvec3 world(const dvec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

struct Next {
  dvec3 wi{0.0}, weight{0.0};  // local; weight = f |cos| / pdf
};

/// What a light sends to a point, but for shadows: direction to it, distance, and lx on a facing surface.
struct Arrival {
  dvec3 direction{0.0};
  double distance = 0.0;
  dvec3 illuminance{0.0};
};

Arrival arrival(const PunctualLight& light, const dvec3& point) {
  if (light.parallel) return {-light.axis, std::numeric_limits<double>::infinity(), light.intensity};
  const dvec3 d = light.position - point;
  const double squared = glm::dot(d, d), distance = std::sqrt(squared);
  double fade = 1.0;
  if (light.cosOuter >= -1.0) {  // KHR_lights_punctual: the square of a linear ramp in the cosine
    const double cosine = -glm::dot(d, light.axis) / distance;
    const double ramp = (cosine - light.cosOuter) / (light.cosInner - light.cosOuter);
    fade = std::pow(std::clamp(ramp, 0.0, 1.0), 2.0);
  }
  return {d / distance, distance, light.intensity * (fade / squared)};
}

/// Where a ray really ends: half transparent surfaces let some of them pass.
std::optional<Hit> firstOpaque(const World& world, const Ray& ray, double tMin, Random& random) {
  for (auto hit = nearest(world, ray, tMin);; hit = nearest(world, ray, hit->t)) {
    const double opacity = hit ? opacityAt(*hit) : 1.0;
    if (opacity == 1.0 || random.uniform() < opacity) return hit;
  }
}

/// Whether a direction is on the same side of the facet as of the shading normal: else it is not scattered
/// to (Veach 1997, section 5.3).
bool sidesAgree(const dvec3& facet, const dvec3& worldWi, const dvec3& localWi) {
  return glm::dot(facet, worldWi) * localWi.z > 0.0;
}

/// `facet`: the surface's own normal, on the side that the ray came from.
dvec3 punctualLight(const World& world, const Bsdf& bsdf, const Frame& frame, const dvec3& facet,
                    const dvec3& point, Random& random) {
  dvec3 L(0.0);
  for (const PunctualLight& light : world.punctual) {
    const Arrival a = arrival(light, point);
    const dvec3 wi = frame.local(a.direction);
    const dvec3 reflected = bsdf.evaluate(wi) * std::abs(wi.z) * a.illuminance;
    if (reflected == dvec3(0.0) || !sidesAgree(facet, a.direction, wi)) continue;
    const auto blocker = firstOpaque(world, {point, a.direction}, selfDistance(point), random);
    if (!blocker || blocker->t >= a.distance) L += reflected;
  }
  return L;
}

/// Either one of the mirrors, or an even direction: half the paths each when there are both.
Next next(const Bsdf& bsdf, Random& random) {
  const auto mirrors = bsdf.deltas();
  const double pScatter = !bsdf.scatters() ? 0.0 : mirrors.empty() ? 1.0 : 0.5;
  if (random.uniform() < pScatter) {
    dvec3 wi = random.onSphere();
    const bool through = bsdf.scattersThrough();
    if (!through) wi.z = std::abs(wi.z);
    const double pdf = pScatter / ((through ? 4.0 : 2.0) * std::numbers::pi);
    return {wi, bsdf.evaluate(wi) * (std::abs(wi.z) / pdf)};
  }
  double total = 0.0;
  const auto size = [](const DeltaLobe& lobe) { return lobe.energy.x + lobe.energy.y + lobe.energy.z; };
  for (const DeltaLobe& lobe : mirrors) total += size(lobe);
  double u = random.uniform() * total;
  for (const DeltaLobe& lobe : mirrors) {
    if (u < size(lobe))
      return {lobe.wi, lobe.energy * (lobe.compression * total / size(lobe) / (1.0 - pScatter))};
    u -= size(lobe);
  }
  return {};
}

/// Beer and Lambert: what is left after `distance` metres within a solid.
dvec3 transmittance(const Material* medium, double distance) {
  if (!medium || medium->attenuationDistance <= 0.0f) return dvec3(1.0);
  return glm::pow(dvec3(medium->attenuationColor), dvec3(distance / medium->attenuationDistance));
}

}  // namespace

dvec3 radiance(const World& world, Ray ray, int maxBounces, Random& random) {
  dvec3 L(0.0), beta(1.0);
  const Material* medium = nullptr;  // that the ray runs through; null = air
  double tMin = 0.0;
  for (int depth = 0; depth <= maxBounces + 1 && beta != dvec3(0.0); ++depth) {
    const auto hit = firstOpaque(world, ray, tMin, random);
    if (!hit) return L + beta * world.background(ray.direction);
    beta *= transmittance(medium, hit->t);

    // Emission of what was met
    const Body& body = *hit->body;
    const bool outside = glm::dot(ray.direction, hit->normal) < 0.0;
    if (body.finish ? depth <= maxBounces : outside || !body.oneSided) L += beta * emissionAt(*hit);
    if (!body.finish || depth > maxBounces) return L;

    // Light from where no ray leads
    const double side = outside ? 1.0 : -1.0;
    const dvec3 facet = side * hit->normal, point = ray.at(hit->t);
    const Frame frame(side * shadingNormal(*hit));
    const dvec3 wo = frame.local(-ray.direction);
    if (wo.z <= 0.0) return L;  // the facet faces the viewer, its smooth normal does not
    const auto painted = paintedFinish(*hit);
    const Bsdf bsdf(painted ? *painted : *body.finish, wo, outside, body.solid());
    L += beta * punctualLight(world, bsdf, frame, facet, point, random);

    // Onward
    const Next step = next(bsdf, random);
    const dvec3 onward = glm::normalize(frame.world(step.wi));
    beta *= sidesAgree(facet, onward, step.wi) ? step.weight : dvec3(0.0);
    if (step.wi.z < 0.0 && body.solid()) medium = outside ? &body.finish->material : nullptr;
    ray = {point, onward};
    tMin = selfDistance(point);
  }
  return L;
}

}  // namespace steradian::oracle
