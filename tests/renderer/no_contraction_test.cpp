// SPDX-License-Identifier: MIT
// What `precise` promises is in the shipped SPIR-V: a compiler that fuses these products and sums breaks the
// proofs of the triangle test and of the film's sums, and lavapipe, which never fuses, would not show
// it.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "renderer/shader_code.hpp"
#include "tests/measured.hpp"

namespace steradian {
namespace {

// SPIR-V 1.5, 3.32 and 3.20.
constexpr std::uint32_t opName = 5, opFunction = 54, opFunctionEnd = 56, opDecorate = 71, opFAdd = 129,
                        opFSub = 131, opFMul = 133, noContraction = 42;

struct Arithmetic {
  std::uint32_t op, result, left, right;
};

struct Module {
  std::set<std::uint32_t> exact;
  int checked = 0, loose = 0;
  std::map<std::string, std::vector<Arithmetic>> functions;  // by name, up to the first parenthesis

  explicit Module(std::span<const std::uint32_t> words) {
    std::map<std::uint32_t, std::string> names;
    std::string current;
    for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) {
      const std::uint32_t op = words[at] & 0xffffu;
      if (op == opName) names[words[at + 1]] = reinterpret_cast<const char*>(&words[at + 2]);
      if (op == opDecorate && words[at + 2] == noContraction) exact.insert(words[at + 1]);
      if (op == opFunction) current = names[words[at + 2]].substr(0, names[words[at + 2]].find('('));
      if (op == opFAdd || op == opFSub || op == opFMul)
        functions[current].push_back({op, words[at + 2], words[at + 3], words[at + 4]});
    }
  }

  void expectExact(const std::string& function) {
    const std::vector<Arithmetic>& all = functions[function];
    EXPECT_FALSE(all.empty()) << function << " is not in the module";
    for (const Arithmetic& a : all) {
      EXPECT_TRUE(exact.contains(a.result)) << function << " may be contracted";
      loose += !exact.contains(a.result);
    }
    checked += int(all.size());
  }

  void expectNothingLoose() const {
    EXPECT_EQ(loose, 0);
    measured("operations that may be contracted", loose, 0);
    measuredAtLeast("operations checked in a shader", checked, 1);
  }
};

TEST(NoContraction, row09_the_triangle_test_is_exact_in_every_shader_that_traces) {
  for (const auto& spirv : {pathTraceSpirv(), castRaysSpirv(), pickSpirv(), aovSpirv()}) {
    Module module(spirv);
    module.expectExact("edgeFunction");
    module.expectExact("sheared");
    module.expectNothingLoose();
  }
}

TEST(NoContraction, row09_film_sums_and_double_floats_are_exact_in_the_tracer) {
  Module module(pathTraceSpirv());
  for (const char* function : {"twoSum", "twoProduct", "addDouble", "squareDouble", "addToFilm"})
    module.expectExact(function);
  module.expectNothingLoose();
}

}  // namespace
}  // namespace steradian
