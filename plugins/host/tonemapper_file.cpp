// SPDX-License-Identifier: MIT
// A tonemapper is one annotated GLSL text: no shared object, no build.
#include "plugins/host/tonemapper_file.hpp"

#include <charconv>
#include <iomanip>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "plugins/host/description.hpp"

namespace steradian::plugins {

namespace {

constexpr std::size_t kMostParameters = 8;  // what the display pass has room for

/// The C locale whatever the user's is.
double numberFrom(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw std::runtime_error("expected a number, got \"" + word + "\"");
  return value;
}

double nextNumber(std::istringstream& words, const char* what) {
  std::string word;
  if (!(words >> word))
    throw std::runtime_error(std::string("@param lacks its ") + what +
                             "; expected: @param float name default min max \"unit\" \"help\"");
  return numberFrom(word);
}

std::string nextQuoted(std::istringstream& words) {
  std::string text;
  words >> std::ws;
  if (words.peek() == std::istringstream::traits_type::eof()) return {};
  if (words.peek() != '"') throw std::runtime_error("expected the unit and the help in quotes");
  words >> std::quoted(text);
  return text;
}

/// "whitePoint" -> "white point"
std::string readable(std::string_view id) {
  std::string out;
  for (char c : id) {
    if (c >= 'A' && c <= 'Z') out += ' ', c = char(c - 'A' + 'a');
    out += c == '_' ? ' ' : c;
  }
  return out;
}

Parameter parameterFrom(std::istringstream& words) {
  std::string type;
  Parameter p;
  words >> type >> p.id;
  if (type == "float")
    p.type = Parameter::Type::real;
  else if (type == "int")
    p.type = Parameter::Type::integer;
  else if (type == "bool")
    p.type = Parameter::Type::boolean;
  else
    throw std::runtime_error("expected float, int or bool after @param, got \"" + type + "\"");
  p.name = readable(p.id);
  p.defaultValue = nextNumber(words, "default");
  if (p.type != Parameter::Type::boolean) {
    p.minimum = nextNumber(words, "minimum");
    p.maximum = nextNumber(words, "maximum");
  }
  p.unit = nextQuoted(words);
  p.help = nextQuoted(words);
  checkParameter(p);
  return p;
}

std::string restOf(std::istringstream& words) {
  std::string text;
  std::getline(words >> std::ws, text);
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.pop_back();
  return text;
}

void readLine(Contribution& out, const std::string& line) {
  std::istringstream words(line);
  std::string comment, key;
  if (!(words >> comment >> key) || comment != "//" || key[0] != '@') return;
  if (key == "@id")
    out.id = restOf(words);
  else if (key == "@name")
    out.name = restOf(words);
  else if (key == "@version")
    out.version = restOf(words);
  else if (key == "@param")
    out.parameters.push_back(parameterFrom(words));
  else
    throw std::runtime_error("unknown annotation " + key + "; expected @id, @name, @version or @param");
}

void checkWhole(const Contribution& out) {
  if (!isPluginId(out.id))
    throw std::runtime_error("expected a line like \"// @id org.example.tonemap.film\", got id \"" + out.id +
                             "\"");
  if (out.glsl.find("tonemap(") == std::string::npos)
    throw std::runtime_error("expected a function vec3 tonemap(vec3 sceneLinear)");
  if (out.parameters.size() > kMostParameters)
    throw std::runtime_error("has " + std::to_string(out.parameters.size()) +
                             " parameters; expected at most 8");
  for (std::size_t i = 0; i < out.parameters.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (out.parameters[i].id == out.parameters[j].id)
        throw std::runtime_error("declares the parameter '" + out.parameters[i].id + "' twice");
}

}  // namespace

Contribution parseTonemapper(std::string_view glsl) {
  Contribution out{.kind = Kind::tonemapper, .version = "1.0.0", .glsl = std::string(glsl)};
  std::istringstream lines(out.glsl);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      readLine(out, line);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
  checkWhole(out);
  if (out.name.empty()) out.name = out.id.substr(out.id.rfind('.') + 1);
  return out;
}

}  // namespace steradian::plugins
