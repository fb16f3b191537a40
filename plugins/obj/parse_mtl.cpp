// SPDX-License-Identifier: MIT
// MTL text -> Phong terms and texture statements.
#include <algorithm>

#include "materials.hpp"

namespace obj {

namespace sdk = steradian::sdk;

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return out;
}

/// How many words an option of a texture statement takes at most; those of a vector may be fewer numbers.
std::size_t argumentsOf(std::string_view option) {
  if (option == "-o" || option == "-s" || option == "-t") return 3;
  return option == "-mm" ? 2 : 1;
}

bool isMap(std::string_view key) {
  return key.starts_with("map_") || key == "bump" || key == "norm" || key == "disp" || key == "decal" ||
         key == "refl";
}

}  // namespace

void Materials::read(const std::string& names) {
  std::string name = names;
  std::ranges::replace(name, '\\', '/');
  sdk::Text bytes;
  if (host_.readBeside(name, bytes)) return parse(name, bytes.view());
  const std::string whole = bytes.str();
  Words words(name);
  if (words.next() == name) return host_.notKept("material library " + name, "left out: " + whole);
  Words each(name);
  for (std::string_view word; !(word = each.next()).empty();) {
    if (host_.readBeside(word, bytes))
      parse(std::string(word), bytes.view());
    else
      host_.notKept("material library " + std::string(word), "left out: " + bytes.str());
  }
}

void Materials::parse(const std::string& file, std::string_view bytes) {
  Lines lines(bytes);
  std::string_view line;
  Phong* current = nullptr;
  while (lines.next(line)) {
    Words words(line);
    const std::string key = lower(words.next());
    if (key == "newmtl")
      current = &(known_[std::string(words.rest())] = {});
    else if (current && !key.empty())
      try {
        statement(*current, key, words, lines.number());
      } catch (const sdk::BadInput& error) {
        host_.notKept(file,
                      std::string("left out: ") + error.what());  // the geometry is worth more than one value
      }
  }
}

void Materials::statement(Phong& m, std::string_view key, Words& words, std::size_t line) {
  if (isMap(key)) {
    m.maps[std::string(key)] = mapOf(words);
    return;
  }
  const auto color = [&](float(&out)[3]) {
    const std::string_view first = words.next();
    if (first == "spectral" || first == "xyz") failAt(line, quoted(key) + " is given as " + quoted(first));
    out[0] = out[1] = out[2] = numberAt(line, first);
    const std::string_view green = words.next();
    if (!green.empty()) out[1] = numberAt(line, green), out[2] = numberAt(line, words.next());
  };
  const auto one = [&](float& out) { out = numberAt(line, words.next()); };
  if (key == "kd") return color(m.diffuse);
  if (key == "ks") return color(m.specular);
  if (key == "ke") return color(m.emission);
  if (key == "ns") return one(m.shininess);
  if (key == "ni") return one(m.ior);
  if (key == "pr") return one(m.roughness);
  if (key == "pm") return one(m.metallic);
  if (key == "pc") return one(m.clearcoat);
  if (key == "pcr") return one(m.clearcoatRoughness);
  if (key == "tr") return one(m.opacity), void(m.opacity = 1 - m.opacity);
  if (key == "illum") return m.illumination = int(numberAt(line, words.next())), void();
  if (key != "d") return;
  std::string_view word = words.next();
  if (word == "-halo") word = words.next();
  m.opacity = numberAt(line, word);
}

Materials::Map Materials::mapOf(Words& words) {
  Map map;
  while (words.rest().starts_with('-')) {
    const std::string option = lower(words.next());
    float values[3] = {0, 0, 0};
    for (std::size_t i = 0; i < argumentsOf(option); ++i) {
      Words ahead = words;
      const std::string_view word = ahead.next();
      const auto value = sdk::numberIn(word);
      if (argumentsOf(option) == 3 && !value) break;
      values[i] = float(std::clamp(value.value_or(word == "on"), -1e6, 1e6));
      words = ahead;
    }
    if (option == "-s") std::copy_n(values, 2, map.scale);
    if (option == "-o") std::copy_n(values, 2, map.offset);
    if (option == "-bm") map.strength = std::clamp(values[0], 0.0f, 100.0f);
    if (option == "-clamp") map.clamp = values[0] != 0;
  }
  map.file = words.rest();
  std::ranges::replace(map.file, '\\', '/');
  return map;
}

}  // namespace obj
