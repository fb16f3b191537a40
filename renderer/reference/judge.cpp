// SPDX-License-Identifier: MIT
// Unpacks what path_record.glsl wrote, repeats each stage, compares.
#include "renderer/reference/judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "renderer/reference/shaders.hpp"

namespace steradian::reference {
namespace {

using Double = Shaders<double>;
using Rows = std::span<const glm::vec4>;

std::uint32_t indexOf(float number) {
  return number < 0.0f ? gpu::NO_PRIMITIVE : std::uint32_t(number);
}

// The largest float is not the largest number of a double build: a miss stays a miss.
double distanceOf(float distance) {
  return distance >= 1e30f ? 1e30 : double(distance);
}

glm::dvec3 vectorOf(const glm::vec4& row) {
  return glm::dvec3(row);
}

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.9g", value);
  return buffer;
}
std::string text(const glm::dvec3& v) {
  return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
}

double relative(double difference, double scale) {
  return difference == 0.0 ? 0.0 : difference / scale;
}

// Findings of one vertex.
class Notes {
 public:
  Notes(std::vector<Finding>& findings, int vertex) : findings_(findings), vertex_(vertex) {}
  int slot = -1;

  void number(Quantity q, double device, double reference, double atLeast = 0.0) {
    const double scale = std::max({std::fabs(device), std::fabs(reference), atLeast});
    add(q, std::fabs(device - reference), scale, text(device), text(reference), glm::dvec3(reference, 0, 0));
  }
  void vector(Quantity q, const glm::dvec3& device, const glm::dvec3& reference, double atLeast = 0.0) {
    const double scale = std::max({glm::length(device), glm::length(reference), atLeast});
    add(q, glm::length(device - reference), scale, text(device), text(reference), reference);
  }
  void index(Quantity q, std::uint32_t device, std::uint32_t reference) {
    const auto name = [](std::uint32_t i) { return i == gpu::NO_PRIMITIVE ? "none" : std::to_string(i); };
    add(q, device == reference ? 0.0 : 1.0, 1.0, name(device), name(reference), glm::dvec3(reference, 0, 0));
  }
  void truth(Quantity q, bool device, bool reference) {
    add(q, device == reference ? 0.0 : 1.0, 1.0, device ? "yes" : "no", reference ? "yes" : "no",
        glm::dvec3(reference ? 1 : 0, 0, 0));
  }

 private:
  void add(Quantity q, double difference, double scale, std::string device, std::string reference,
           glm::dvec3 value) {
    findings_.push_back({q, vertex_, slot, relative(difference, scale), std::move(device),
                         std::move(reference), value, scale});
  }
  std::vector<Finding>& findings_;
  int vertex_;
};

// Rows of a vertex with every measured number off by up to 4 units in the last place; indices and flags stay.
class Disturbance {
 public:
  explicit Disturbance(std::uint64_t seed) : engine_(seed) {}

  std::vector<glm::vec4> of(Rows vertex, const Double& layout) {
    std::vector<glm::vec4> rows(vertex.begin(), vertex.end());
    for (const auto at : {layout.RECORD_STATE, layout.RECORD_STATE + 1u, layout.RECORD_STATE + 2u,
                          layout.RECORD_SURFACE, layout.RECORD_SURFACE + 1u, layout.RECORD_SURFACE + 2u,
                          layout.RECORD_NEXT, layout.RECORD_NEXT + 1u})
      move(rows[at]);
    rows[layout.RECORD_HIT].x *= float(1.0 + off());
    for (std::uint32_t slot = 0; slot <= layout.RECORD_SKY; ++slot)
      move(rows[layout.RECORD_LIGHTS + slot * layout.RECORD_LIGHT_ROWS + 1u]);
    return rows;
  }

 private:
  double off() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_) * 0x1p-21; }
  void move(glm::vec4& row) {
    const double length = glm::length(vectorOf(row));
    row = glm::vec4(glm::vec3(vectorOf(row) + length * glm::dvec3(off(), off(), off())), row.w);
  }
  std::mt19937_64 engine_;
};

}  // namespace

struct Judge::Impl {
  explicit Impl(const TracedScene& traced)
      : traced(traced),
        shaders(Kinds{traced.scene.features, traced.scene.shapeHierarchy(), traced.scene.meshLights,
                      traced.scene.solidLights}) {
    shaders.sceneRows = traced.scene.rows;
    shaders.tableRows = traced.tables;
    shaders.meshRows = traced.meshes;
    shaders.texels = traced.texels;
  }

  void startPath(const PathRecord& record) {
    shaders.params = Double::Params(paramsOfSample(traced, record.sample));
    pixel = {std::uint32_t(record.x), std::uint32_t(record.y)};
    layout = shaders.primitiveLayout();
  }

  Double::Path pathOf(Rows state) const {
    Double::Path path{};
    path.ray = Double::Ray(vectorOf(state[0]), vectorOf(state[1]), indexOf(state[0].w), state[1].w != 0.0f);
    path.throughput = vectorOf(state[2]);
    path.pdf = state[2].w;
    path.absorption = vectorOf(state[3]);
    path.bounce = std::uint32_t(state[3].w);
    path.radiance = vectorOf(state[4]);
    path.index = std::uint32_t(state[4].w);
    path.width = state[5].x;
    path.spread = state[5].y;
    path.compression = state[5].z;
    return path;
  }

  Double::Hit hitOf(const glm::vec4& hit) const {
    const std::uint32_t primitive = std::min(indexOf(hit.y), layout.end - 1u);
    return {distanceOf(hit.x), primitive, std::bit_cast<std::uint32_t>(hit.z)};
  }

  // The surface as the device found it, in which later stages start.
  Double::Vertex vertexOf(Rows surface, const Double::Path& path, const glm::vec4& hit) {
    Double::Vertex v = shaders.vertexAt(hitOf(hit), path, shaders.pathSeed(pixel), layout);
    v.surface.p = vectorOf(surface[0]);
    v.inside = surface[0].w != 0.0f;
    v.frame = shaders.frameAround(vectorOf(surface[1]));
    v.wo = vectorOf(surface[2]);
    return v;
  }

  void compareCamera(Rows device, Notes& notes) {
    const auto seed = shaders.pathSeed(pixel);
    const auto index = shaders.params.sampleBegin;
    const Double::Path path =
        shaders.cameraPath(shaders.fetchCamera(), pixel, shaders.pairAt(seed, index, 0u), seed, index);
    notes.vector(Quantity::camera, vectorOf(device[1]), path.ray.d);
  }

  void compareHit(glm::vec4 row, const Double::Path& path, Notes& notes) {
    const Double::Hit hit = shaders.nextHit(path, shaders.pathSeed(pixel), layout);
    notes.index(Quantity::primitive, indexOf(row.y), hit.primitive);
    if (hit.primitive == indexOf(row.y) && row.y >= 0.0f)
      notes.number(Quantity::distance, row.x, hit.t, glm::length(path.ray.o));
  }

  void compareSurface(glm::vec4 hit, Rows row, const Double::Path& path, Notes& notes) {
    const Double::Vertex v = shaders.vertexAt(hitOf(hit), path, shaders.pathSeed(pixel), layout);
    notes.vector(Quantity::point, vectorOf(row[0]), v.surface.p,
                 std::max(double(hit.x), glm::length(path.ray.o)));
    notes.vector(Quantity::normal, vectorOf(row[1]), v.frame.n);
    notes.vector(Quantity::outgoing, vectorOf(row[2]), v.wo);
  }

  // `given`: what the slot's later stages start from.
  void compareSlot(Rows row, Rows given, std::uint32_t slot, Double::Vertex& v, Notes& notes) {
    if (row[0].x == 0.0f) return;
    notes.slot = int(slot);
    const bool sky = slot == shaders.RECORD_SKY;
    const Double::LightChoice choice(indexOf(row[0].y), row[0].z);
    if (!sky) notes.index(Quantity::light, choice.light, shaders.lightOfSlot(v, slot).light);
    const Double::LightSample s = shaders.sampleOfSlot(v, slot, choice);
    const auto sampleIn = [](Rows r) {
      return Double::LightSample(vectorOf(r[1]), distanceOf(r[1].w), vectorOf(r[2]), r[2].w, indexOf(r[4].w));
    };
    const Double::LightSample device = sampleIn(row), sent = sampleIn(given);
    notes.vector(Quantity::lightDirection, device.wi, s.wi);
    notes.number(Quantity::lightDistance, device.distance, s.distance, glm::length(v.surface.p));
    notes.vector(Quantity::illuminance, device.illuminance, s.illuminance);
    notes.number(Quantity::lightPdf, device.pdf, s.pdf);
    const Double::BsdfValue value = shaders.bsdfTowards(v, sent.wi);
    notes.vector(Quantity::bsdf, vectorOf(row[3]), value.fCos);
    notes.number(Quantity::bsdfPdf, row[3].w, value.pdf);
    Double::Tally tally{};
    const glm::dvec3 reflected = shaders.reflectedLight(v, choice, sent, tally, layout);
    const glm::dvec3 reflectedOnDevice = vectorOf(row[4]);
    // Only where light and surface have something to show can the shadow ray be seen.
    const bool lit = shaders.maxComponent(reflectedOnDevice) > 0.0,
               litReference = shaders.maxComponent(reflected) > 0.0;
    if (shaders.maxComponent(vectorOf(row[3])) > 0.0 && shaders.maxComponent(sent.illuminance) > 0.0)
      notes.truth(Quantity::visibility, lit, litReference);
    if (lit && litReference) notes.vector(Quantity::reflected, reflectedOnDevice, reflected);
    notes.slot = -1;
  }

  void compareNext(Rows row, Rows given, const Double::Path& path, double t, Double::Vertex& v,
                   Notes& notes) {
    const Double::BsdfSample next = shaders.nextDirection(v);
    const Double::BsdfSample sent(vectorOf(given[0]), vectorOf(given[1]), row[0].w);
    notes.vector(Quantity::nextDirection, vectorOf(row[0]), next.wi);
    notes.vector(Quantity::nextWeight, vectorOf(row[1]), next.weight);
    notes.number(Quantity::nextPdf, row[0].w, next.pdf);
    notes.vector(Quantity::throughput, vectorOf(row[2]), shaders.continued(path, t, v, sent).throughput);
  }

  // `device`: what the device answered; `given`: the same rows, or disturbed ones, as the inputs of each
  // stage.
  void compareVertex(Rows device, Rows given, int number, std::vector<Finding>& findings) {
    Notes notes(findings, number);
    Double::Path path = pathOf(given.subspan(shaders.RECORD_STATE));
    if (number == 0) compareCamera(device, notes);
    compareHit(device[shaders.RECORD_HIT], path, notes);
    const glm::vec4 hit = given[shaders.RECORD_HIT];
    const bool left = hit.y < 0.0f;
    if (!left) compareSurface(hit, device.subspan(shaders.RECORD_SURFACE), path, notes);
    Double::Vertex v = vertexOf(given.subspan(shaders.RECORD_SURFACE), path, hit);
    path = shaders.arrived(path, double(hit.x));
    // A path that carries nothing meets nothing.
    const bool alive = shaders.maxComponent(path.throughput) > 0.0;
    notes.vector(Quantity::met, vectorOf(device[shaders.RECORD_MET]),
                 alive ? shaders.metLight(path, v, left) : glm::dvec3(0));
    if (left) return;
    for (std::uint32_t slot = 0; slot <= shaders.RECORD_SKY; ++slot) {
      const std::size_t at = shaders.RECORD_LIGHTS + slot * shaders.RECORD_LIGHT_ROWS;
      compareSlot(device.subspan(at), given.subspan(at), slot, v, notes);
    }
    const Rows next = device.subspan(shaders.RECORD_NEXT);
    if (next[1].w == 0.0f) compareNext(next, given.subspan(shaders.RECORD_NEXT), path, hit.x, v, notes);
  }

  // How far the reference moves when its inputs do.
  void measureSensitivity(Rows device, int number, std::span<Finding> findings) {
    constexpr int disturbances = 16;
    Disturbance disturbance(0x5eed);
    std::vector<Finding> moved;
    for (int i = 0; i < disturbances; ++i) {
      moved.clear();
      const std::vector<glm::vec4> given = disturbance.of(device, shaders);
      compareVertex(device, given, number, moved);
      for (Finding& f : findings)
        for (const Finding& m : moved)
          if (m.quantity == f.quantity && m.slot == f.slot)
            f.sensitivity = std::max(f.sensitivity, relative(glm::length(m.value - f.value), f.scale));
    }
  }

  const TracedScene& traced;
  Double shaders;
  glm::uvec2 pixel{};
  Double::Layout layout{};
};

Judge::Judge(const TracedScene& traced) : impl_(std::make_unique<Impl>(traced)) {}
Judge::~Judge() = default;

int vertexCount(const PathRecord& record) {
  return int(record.rows[0].x);
}

std::optional<std::uint32_t> primitiveAt(const PathRecord& record, int vertex) {
  const Shaders<float> layout;
  const float number =
      record.rows[layout.RECORD_HEADER + std::size_t(vertex) * layout.RECORD_VERTEX_ROWS + layout.RECORD_HIT]
          .y;
  return number < 0.0f ? std::nullopt : std::optional(std::uint32_t(number));
}

std::vector<Finding> Judge::compare(const PathRecord& record) {
  impl_->startPath(record);
  std::vector<Finding> findings;
  const Double& layout = impl_->shaders;
  for (int i = 0; i < vertexCount(record); ++i) {
    const Rows vertex =
        Rows(record.rows).subspan(layout.RECORD_HEADER + std::size_t(i) * layout.RECORD_VERTEX_ROWS);
    const std::size_t before = findings.size();
    impl_->compareVertex(vertex, vertex, i, findings);
    const std::span<Finding> own = std::span(findings).subspan(before);
    if (std::ranges::any_of(own, &Finding::parts))
      impl_->measureSensitivity(vertex.first(layout.RECORD_VERTEX_ROWS), i, own);
  }
  return findings;
}

FreeRun Judge::run(const PathRecord& record) {
  impl_->startPath(record);
  Double& s = impl_->shaders;
  s.recordRows.assign(record.rows.size(), glm::dvec4(0));
  s.recordPath(0u, impl_->pixel);
  FreeRun result;
  const int device = vertexCount(record), reference = int(s.recordRows[0].x);
  for (int i = 0; i < std::min(device, reference) && !result.partedAt; ++i) {
    const std::size_t at = s.RECORD_HEADER + std::size_t(i) * s.RECORD_VERTEX_ROWS + s.RECORD_HIT;
    const glm::dvec4 own = s.recordRows[at], theirs(record.rows[at]);
    if (own.y != theirs.y) {
      result.partedAt = i;
      break;
    }
    result.vertices += 1;
    result.distance =
        std::max(result.distance, relative(std::fabs(own.x - theirs.x), std::max(own.x, theirs.x)));
  }
  if (!result.partedAt && device != reference) result.partedAt = result.vertices;
  const glm::dvec3 own(s.recordRows[1]), theirs(record.rows[1]);
  result.radiance = relative(glm::length(own - theirs), std::max(glm::length(own), glm::length(theirs)));
  return result;
}

}  // namespace steradian::reference
