// SPDX-License-Identifier: MIT
// One tiny scene for each feature of the renderer, lit broadly so that the oracle's brute force converges.
#pragma once
#include <string>
#include <vector>

#include "tests/renderer/scenes.hpp"

namespace steradian {

struct AgreementCase {
  std::string feature;  // a C++ identifier
  Scene scene;
  CameraView view;
  int size = 10;             // pixels along both sides
  int samples = 64;          // of each of the renderer's pictures
  int oracleSamples = 4000;  // per pixel
};

std::vector<AgreementCase> punctualCases();
std::vector<AgreementCase> shapeCases();
std::vector<AgreementCase> lightCases();
std::vector<AgreementCase> materialCases();
std::vector<AgreementCase> glassCases();
std::vector<AgreementCase> cameraCases();
std::vector<AgreementCase> meshCases();
std::vector<AgreementCase> textureCases();
std::vector<AgreementCase> lampCases();

}  // namespace steradian
