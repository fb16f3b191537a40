// SPDX-License-Identifier: MIT
// Render settings of the project.
#include "editor/ui/inspector.hpp"
#include "editor/ui/widgets.hpp"

namespace steradian::ui {

namespace {

void pathFields(Fields& fields, RenderSettings& r) {
  fields.integer(
      {.name = "Bounces",
       .help = "Surface interactions after the first hit. A closed white room keeps 91.5, 98.9 and "
               "99.8 % of its light at 4, 8 and 12.",
       .maximum = 64,
       .speed = 0.1,
       .decimals = 0,
       .slider = true,
       .standard = 8},
      r.maxBounces);
  fields.toggle("Russian roulette", "Ends dim paths early after the third bounce, without bias.",
                r.russianRoulette);
  fields.integer({.name = "Light samples",
                  .help = "Lights sampled at each vertex; all of them while they are no more.",
                  .minimum = 1,
                  .maximum = 16,
                  .decimals = 0,
                  .slider = true,
                  .standard = 8},
                 r.lightSamples);
}

void lightFields(Fields& fields, RenderSettings& r) {
  fields.toggle(
      "Energy compensation",
      "Light scattered more than once between microfacets: rough metals keep their brightness. Off: "
      "single scatter, to compare with renderers that leave it out.",
      r.energyCompensation);
  bool clamped = r.clamp > 0.0f;
  if (fields.toggle("Clamp", "Cuts bright outliers of single samples: fewer fireflies, but light is lost.",
                    clamped))
    r.clamp = clamped ? 10.0f : 0.0f;
  if (!clamped) return;
  fields.number({.name = "Clamp at",
                 .help = "Most radiance that one sample may carry beyond its first hit.",
                 .unit = " nit",
                 .minimum = 1e-3,
                 .maximum = 1e10,
                 .decimals = 2,
                 .logarithmic = true,
                 .standard = 10.0},
                r.clamp);
}

void samplingFields(Fields& fields, RenderSettings& r) {
  int filter = int(r.filter);
  if (fields.choice("Pixel filter", "Box: 1 pixel wide. Blackman-Harris: 4 pixels wide, smoother edges.",
                    {"Box", "Blackman-Harris"}, filter))
    r.filter = PixelFilter(filter);
  int seed = int(r.seed);
  if (fields.integer({.name = "Seed",
                      .help = "Another seed gives other noise around the same picture.",
                      .maximum = 1e6,
                      .speed = 0.2,
                      .decimals = 0,
                      .standard = 0},
                     seed))
    r.seed = std::uint32_t(seed);
  fields.toggle("Error meter",
                "Two half-buffers with independent scrambles measure the error that is left. Off: one joint "
                "sequence, less noise for the same samples, but no error figure.",
                r.errorMeter);
}

}  // namespace

std::optional<Edit> inspectRender(Ui& ui, const Scene& scene) {
  Fields fields(ui, "render");
  RenderSettings next = scene.render;
  if (section(ui, "Picture")) {
    NumberField size{.name = "Width",
                     .help = "Of an exported still.",
                     .unit = " px",
                     .minimum = 1,
                     .maximum = 16384,
                     .speed = 2,
                     .decimals = 0,
                     .standard = 1280};
    fields.integer(size, next.width);
    size.name = "Height";
    size.standard = 720;
    fields.integer(size, next.height);
  }
  if (section(ui, "Paths")) pathFields(fields, next);
  if (section(ui, "Light")) lightFields(fields, next);
  if (section(ui, "Sampling")) samplingFields(fields, next);
  if (!fields.changed()) return std::nullopt;
  return Edit{edits::setRender(scene, next), fields.changeName()};
}

}  // namespace steradian::ui
