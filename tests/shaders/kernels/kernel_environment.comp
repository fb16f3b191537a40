#version 460
// SPDX-License-Identifier: MIT
// environment.glsl, sphere_map.glsl and camera.glsl: angles, what the sky shows, directions drawn from it, camera rays.
#extension GL_GOOGLE_include_directive : require
#include "kernel.glsl"
#include "camera.glsl"
#include "environment.glsl"
#include "random.glsl"

void main() {
  uint at = invocation();
  if (kOperation == 0u) {
    answers[at] = vec4(turnOf(questions[at].y, questions[at].x), 0.0, 0.0, 0.0);
  } else if (kOperation == 1u) {
    SkyValue value = environmentAt(questions[at].xyz);
    answers[at] = vec4(value.radiance, value.pdf);
  } else if (kOperation == 3u) {
    CameraRay ray = cameraRay(fetchCamera(), questions[at].x, questions[at].y, questions[at].z, questions[at].w);
    answers[2u * at] = vec4(ray.o, 0.0);
    answers[2u * at + 1u] = vec4(ray.d, 0.0);
  } else {
    LightSample s = sampleEnvironment(sampleIndependent(0x51ed270bu, at, 0u), sampleIndependent(0x51ed270bu, at, 1u));
    answers[3u * at] = vec4(s.wi, s.pdf);
    answers[3u * at + 1u] = vec4(s.illuminance, environmentPdf(s.wi));
    answers[3u * at + 2u] = vec4(environmentRadiance(s.wi), 0.0);
  }
}
