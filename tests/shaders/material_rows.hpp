// SPDX-License-Identifier: MIT
// Scene materials as kernel_material.comp sees them, and the share of light that they give back.
#pragma once
#include "renderer/energy_table.hpp"
#include "renderer/gpu_materials.hpp"
#include "shaders/kernel_material.comp.h"
#include "tests/shaders/bsdf_rows.hpp"

namespace steradian::kernel {

inline const Kernel materialKernel{kernel_material_spirv, "material"};
inline constexpr float insideBit = 1, thinBit = 2;

inline Task materialTask(std::uint32_t operation, const std::vector<steradian::Material>& materials,
                         bool compensation) {
  Task task{.operation = operation, .rowsIn = 2, .rowsOut = operation == 0 ? 2u : 1u};
  gpu::TraceParams params{};
  params.flags = compensation ? gpu::TRACE_COMPENSATION : 0u;
  task.push = pushBytes(params);
  GlassTables tables;
  GlassPlaces glass(tables, compensation);
  Rows behind(materials.size() * gpu::MATERIAL_ROWS);
  for (const steradian::Material& m : materials) {
    const std::uint32_t bits = materialBits(m, {});
    pushMaterial(task.scene, m, bits, gpu::NO_LIGHT, glm::uvec4(0), glass.rowOf(m, bits, behind));
  }
  task.scene.insert(task.scene.end(), behind.begin() + std::ptrdiff_t(task.scene.size()), behind.end());
  task.tables = energyTable();
  return task;
}

/// What a material does with even light, seen at one cosine.
struct Share {
  double reflected = 0, transmitted = 0;  // radiance; transmitted light without its compression by eta^2
  double total() const { return reflected + transmitted; }
};

inline constexpr std::uint32_t samplesPerShare = 8192;

/// The digits of i in `base`, mirrored behind the point (van der Corput).
inline double radicalInverse(std::uint32_t i, std::uint32_t base) {
  double inverse = 0.0, digit = 1.0 / base;
  for (; i != 0; i /= base, digit /= base) inverse += digit * (i % base);
  return inverse;
}

/// Questions that sample a material at Hammersley's points of the unit cube.
inline void pushSamples(Rows& rows, std::size_t material, double mu, float flags) {
  const glm::vec4 wo(glm::vec3(direction(mu, 0.7)), float(material));
  for (std::uint32_t i = 0; i < samplesPerShare; ++i)
    rows.insert(rows.end(), {wo, glm::vec4((i + 0.5) / samplesPerShare, radicalInverse(i, 2),
                                           radicalInverse(i, 3), flags)});
}

/// Mean of their answers, from index `first` on, one channel.
inline Share meanShare(const Rows& answers, std::size_t first, double eta2, int channel = 0) {
  Share share;
  for (std::size_t i = first; i < first + samplesPerShare; ++i) {
    const bool through = answers[2 * i].z < 0;
    (through ? share.transmitted : share.reflected) +=
        double(answers[2 * i + 1][channel]) * (through ? eta2 : 1.0) / samplesPerShare;
  }
  return share;
}

}  // namespace steradian::kernel
