// SPDX-License-Identifier: MIT
// What a plugin says about itself, checked, and as JSON for the probe's pipe and cache.
#include "plugins/host/description.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace steradian::plugins {

namespace {

Parameter parameterOf(const sdk::ParameterInfo& info) {
  Parameter out{
      .id = info.id.str(), .name = info.name.str(), .unit = info.unit.str(), .help = info.help.str()};
  out.type = info.type == sdk::ParameterType::boolean   ? Parameter::Type::boolean
             : info.type == sdk::ParameterType::integer ? Parameter::Type::integer
                                                        : Parameter::Type::real;
  out.defaultValue = info.defaultValue;
  out.minimum = info.minimum;
  out.maximum = info.maximum;
  checkParameter(out);
  return out;
}

Contribution contributionOf(Kind kind, const sdk::FormatInfo& theirs) {
  const sdk::FormatInfo info = sdk::adopt(theirs);
  Contribution out{.kind = kind, .id = info.id.str(), .name = info.name.str(), .version = info.version.str()};
  if (!isPluginId(out.id)) throw std::runtime_error("has a bad id '" + out.id + "'");
  std::istringstream extensions(info.extensions.str());
  for (std::string extension; extensions >> extension;) {
    if (extension[0] != '.' || extension.size() < 2)
      throw std::runtime_error(out.id + " has a bad file extension '" + extension + "'; expected like .exr");
    out.extensions.push_back(extension);
  }
  out.takesImage = kind == Kind::exporter && info.takesImage;
  out.takesScene = kind == Kind::exporter && !info.takesImage;
  for (std::uint32_t i = 0; i < info.parameterCount; ++i)
    out.parameters.push_back(parameterOf(info.parameters[i]));
  return out;
}

bool isWord(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
}

std::vector<long> numbersOf(std::string_view version) {
  std::vector<long> numbers;
  while (!version.empty()) {
    long number = 0;
    std::from_chars(version.data(), version.data() + version.size(), number);
    numbers.push_back(number);
    const auto dot = version.find('.');
    version.remove_prefix(dot == version.npos ? version.size() : dot + 1);
  }
  while (!numbers.empty() && numbers.back() == 0) numbers.pop_back();
  return numbers;
}

nlohmann::json toJson(const Parameter& p) {
  return {{"id", p.id},     {"name", p.name}, {"unit", p.unit},
          {"help", p.help}, {"type", p.type}, {"range", {p.defaultValue, p.minimum, p.maximum}}};
}

Parameter parameterFromJson(const nlohmann::json& json) {
  Parameter p{json.at("id"), json.at("name"), json.at("unit"), json.at("help"), json.at("type")};
  p.defaultValue = json.at("range").at(0);
  p.minimum = json.at("range").at(1);
  p.maximum = json.at("range").at(2);
  return p;
}

}  // namespace

bool isPluginId(std::string_view id) {
  std::size_t words = 0;
  for (std::size_t begin = 0; begin <= id.size(); ++words) {
    const std::size_t end = std::min(id.find('.', begin), id.size());
    if (!isWord(id.substr(begin, end - begin))) return false;
    begin = end + 1;
  }
  return words >= 2;
}

bool versionLess(std::string_view a, std::string_view b) {
  return numbersOf(a) < numbersOf(b);
}

void checkParameter(const Parameter& p) {
  const bool startsWell = isWord(p.id) && !std::isdigit(static_cast<unsigned char>(p.id[0])) &&
                          p.id.find('-') == std::string::npos;
  if (!startsWell)
    throw std::runtime_error("has a parameter with a bad id '" + p.id + "'; expected a plain word");
  if (!(std::isfinite(p.minimum) && std::isfinite(p.maximum) && p.minimum <= p.defaultValue &&
        p.defaultValue <= p.maximum && p.minimum < p.maximum))
    throw std::runtime_error("parameter '" + p.id + "': expected minimum <= default <= maximum, all finite");
}

std::vector<Contribution> describe(const Library& library) {
  std::vector<Contribution> out;
  for (auto* importer : library.importers) out.push_back(contributionOf(Kind::importer, importer->info()));
  for (auto* exporter : library.exporters) out.push_back(contributionOf(Kind::exporter, exporter->info()));
  return out;
}

nlohmann::json toJson(const std::vector<Contribution>& contributions) {
  nlohmann::json out = nlohmann::json::array();
  for (const Contribution& c : contributions) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const Parameter& p : c.parameters) parameters.push_back(toJson(p));
    out.push_back({{"kind", c.kind},
                   {"id", c.id},
                   {"name", c.name},
                   {"version", c.version},
                   {"extensions", c.extensions},
                   {"takesImage", c.takesImage},
                   {"parameters", std::move(parameters)}});
  }
  return out;
}

std::vector<Contribution> contributionsFromJson(const nlohmann::json& json) {
  std::vector<Contribution> out;
  for (const auto& entry : json) {
    Contribution c{entry.at("kind"), entry.at("id"), entry.at("name"), entry.at("version")};
    entry.at("extensions").get_to(c.extensions);
    c.takesImage = entry.at("takesImage");
    c.takesScene = c.kind == Kind::exporter && !c.takesImage;
    for (const auto& parameter : entry.at("parameters")) c.parameters.push_back(parameterFromJson(parameter));
    out.push_back(std::move(c));
  }
  return out;
}

}  // namespace steradian::plugins
