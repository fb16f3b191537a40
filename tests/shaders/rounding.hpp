// SPDX-License-Identifier: MIT
// How much float loses: what tests share that ask a function on the device, in C++ float and in double.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>

#include "tests/shaders/kernel.hpp"

namespace steradian::kernel {

/// Relative errors that float may show: of 99.9 % of the answers, and of all. `flips`: the share of answers
/// where rounding may decide between hit and miss or, with `choice`, between neighbours (an error beyond
/// `all`).
template <class Question>
struct Gate {
  const char* name;
  std::uint32_t operation;
  std::function<Question(Random&)> question;
  double most, all;
  double flips = 1e-4;
  bool choice = false;
};

struct Errors {
  double most = 0.0, all = 0.0;  // 99.9 %, maximum
  std::size_t flips = 0, compared = 0;
};

/// Answers of 1e29 and more are misses. `choice`: errors beyond it are flips; 0 = none.
inline Errors errorsOf(const std::vector<glm::dvec4>& answers, const std::vector<glm::dvec4>& exact,
                       double choice = 0.0) {
  Errors errors;
  std::vector<double> relative;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const bool miss = answers[i].x >= 1e29, exactMiss = exact[i].x >= 1e29;
    errors.flips += miss != exactMiss ? 1 : 0;
    if (miss || exactMiss) continue;
    const double difference = glm::length(answers[i] - exact[i]), size = glm::length(exact[i]);
    const double error = difference == 0.0 ? 0.0 : size > 1e-30 ? difference / size : difference;
    const bool flipped = choice > 0.0 && error > choice;
    errors.flips += flipped ? 1 : 0;
    if (!flipped) relative.push_back(error);
  }
  std::ranges::sort(relative, [](double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); });
  errors.compared = relative.size();
  if (relative.empty()) return errors;
  errors.most = relative[std::size_t(double(relative.size() - 1) * 0.999)];
  errors.all = relative.back();
  return errors;
}

inline void printRoundingHead() {
  std::printf("%-28s%12s%12s%8s%12s%12s%8s\n", "relative error", "GPU 99.9 %", "max", "flips", "C++ 99.9 %",
              "max", "flips");
}

template <class Question>
void expectWithin(const Gate<Question>& gate, const Errors& gpu, const Errors& cpu, std::size_t questions) {
  std::printf("%-28s%12.1e%12.1e%8zu%12.1e%12.1e%8zu\n", gate.name, gpu.most, gpu.all, gpu.flips, cpu.most,
              cpu.all, cpu.flips);
  for (const Errors& e : {gpu, cpu}) {
    EXPECT_LE(e.most, gate.most) << gate.name;
    EXPECT_LE(e.all, gate.all) << gate.name;
    EXPECT_LE(double(e.flips), gate.flips * double(questions)) << gate.name;
    EXPECT_GE(e.compared, questions / 5) << gate.name << ": the questions miss";
  }
  measured(std::string(gate.name) + ", relative error of 99.9 %", std::max(gpu.most, cpu.most), gate.most);
}

}  // namespace steradian::kernel
