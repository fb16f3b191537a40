// SPDX-License-Identifier: MIT
// steradian compare A B: the difference of two images, B being the reference.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/commands.hpp"
#include "editor/cli/console.hpp"
#include "editor/cli/image_compare.hpp"
#include "editor/cli/verify.hpp"
#include "editor/image_file.hpp"
#include "renderer/scene/error.hpp"

namespace steradian::cli {

namespace {

struct CompareOptions {
  std::filesystem::path image, reference;
  std::vector<std::string> failAbove;  // as typed
  bool json = false;
};

void printJson(const ImageDifference& d) {
  nlohmann::ordered_json json = {{"meanRatio", d.meanRatio}};
  for (const auto& [name, value] : figuresOf(d)) json[name] = value;
  json["nan"] = d.nan;
  json["inf"] = d.inf;
  std::puts(json.dump(2).c_str());
}

void printText(const ImageDifference& d) {
  std::printf("%-14s%.6g %.6g %.6g\n", "meanRatio", d.meanRatio[0], d.meanRatio[1], d.meanRatio[2]);
  for (const auto& [name, value] : figuresOf(d)) std::printf("%-14s%.6g\n", name.c_str(), value);
  std::printf("%-14s%llu, %llu\n", "nan, inf", (unsigned long long)(d.nan), (unsigned long long)(d.inf));
}

Encoding encodingOf(const ImageFile& file) {
  return file.format == "png" ? Encoding::display : Encoding::sceneLinear;
}

int runCompare(const CompareOptions& options) {
  if (options.reference.empty()) throw Error(ExitCode::usage, "compare: a reference image is required");
  std::vector<FigureLimit> limits;
  for (const std::string& text : options.failAbove) limits.push_back(parseLimit(text));
  const ImageFile image = readImage(options.image), reference = readImage(options.reference);
  const ImageDifference difference =
      differenceOf(image.image, reference.image, {encodingOf(image), encodingOf(reference)});
  options.json ? printJson(difference) : printText(difference);
  const auto failures = exceeded(difference, limits);
  for (const std::string& line : failures) fail(options.image.string() + ": " + line);
  return failures.empty() ? 0 : int(ExitCode::failed);
}

}  // namespace

void addCompare(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Error of an image against a reference");
  command->add_option("image", options->image, "EXR (or PNG) to judge; with --verify-pixel a project")
      ->required();
  command->add_option("reference", options->reference, "EXR (or PNG) to compare with");
  command
      ->add_option("--fail-above", options->failAbove,
                   "End with 1 when a figure is larger, e.g. relRmse=0.01; repeatable")
      ->allow_extra_args(false);
  const auto verify = addVerifyOptions(*command);
  command->add_flag("--json", options->json, "Machine-readable output, of the difference of two images")
      ->excludes("--verify-pixel");
  command->callback([options, verify, &chosen] {
    chosen = [options, verify] {
      return verify->pixels.empty() ? runCompare(*options) : runVerify(*verify, options->image);
    };
  });
}

}  // namespace steradian::cli
