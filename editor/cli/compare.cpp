// SPDX-License-Identifier: MIT
// steradian compare A B: the difference of two images, B being the reference.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/commands.hpp"
#include "editor/cli/image_compare.hpp"
#include "editor/cli/image_file.hpp"

namespace steradian::cli {

namespace {

struct CompareOptions {
  std::filesystem::path image, reference;
  bool json = false;
};

void printJson(const ImageDifference& d) {
  const nlohmann::ordered_json json = {
      {"meanRatio", d.meanRatio}, {"mse", d.mse}, {"relMse", d.relMse}, {"relRmse", d.relRmse},
      {"smape", d.smape},         {"max", d.max}, {"nan", d.nan},       {"inf", d.inf}};
  std::puts(json.dump(2).c_str());
}

void printText(const ImageDifference& d) {
  std::printf("mean ratio  %.6g %.6g %.6g\n", d.meanRatio[0], d.meanRatio[1], d.meanRatio[2]);
  std::printf("MSE         %.6g\n", d.mse);
  std::printf("relMSE      %.6g\n", d.relMse);
  std::printf("relRMSE     %.6g\n", d.relRmse);
  std::printf("SMAPE       %.6g\n", d.smape);
  std::printf("max         %.6g\n", d.max);
  std::printf("NaN, Inf    %llu, %llu\n", (unsigned long long)(d.nan), (unsigned long long)(d.inf));
}

int runCompare(const CompareOptions& options) {
  const ImageDifference difference =
      differenceOf(readImage(options.image).image, readImage(options.reference).image);
  options.json ? printJson(difference) : printText(difference);
  return 0;
}

}  // namespace

void addCompare(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Error of an image against a reference");
  command->add_option("image", options->image, "EXR (or PNG) to judge")->required();
  command->add_option("reference", options->reference, "EXR (or PNG) to compare with")->required();
  command->add_flag("--json", options->json, "Machine-readable output");
  command->callback([options, &chosen] { chosen = [options] { return runCompare(*options); }; });
}

}  // namespace steradian::cli
