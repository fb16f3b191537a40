// SPDX-License-Identifier: MIT
// OBJ text -> Model.
#include <cmath>
#include <limits>
#include <unordered_map>

#include "model.hpp"

namespace obj {

namespace sdk = steradian::sdk;

namespace {

constexpr std::size_t kMostElements = std::numeric_limits<std::int32_t>::max();

/// IEC 61966-2-1: the colours that programs write are meant for the screen.
float linearFromSrgb(float c) {
  c = std::fmin(std::fmax(c, 0.0f), 1.0f);
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

class Parser {
 public:
  Parser(sdk::Host& host, std::string_view bytes) : host_(host), size_(bytes.size()), lines_(bytes) {}

  Model parse() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % 65536 == 0) report();
      if (line.find('\0') != line.npos)
        failAt(lines_.number(), "holds a zero byte; expected OBJ as ASCII or UTF-8 text");
      Words words(line);
      statement(words.next(), words);
    }
    checkIndices();
    return std::move(model_);
  }

 private:
  void report() {
    if (host_.cancelled()) throw sdk::Cancelled{};
    host_.progress(0.7 * double(lines_.position()) / double(size_));
  }

  void statement(std::string_view key, Words& words) {
    if (key == "v") return vertex(words);
    if (key == "vt") return uv(words);
    if (key == "vn") return model_.normals.push_back(threeOf(words)), checkCount(model_.normals.size());
    if (key == "f" || key == "fo") return face(words);
    if (key == "o" || key == "g") return part_ = nullptr, void(name_ = words.rest());
    if (key == "usemtl") return part_ = nullptr, void(material_ = words.rest());
    if (key == "mtllib") return model_.libraries.push_back(std::string(words.rest()));
    if (key == "s") return smoothing(words.next());
    if (!key.empty()) leaveOut(key.substr(0, 20));
  }

  void leaveOut(std::string_view key) {
    const bool listed = model_.leftOut.size() < 20 || model_.leftOut.count(std::string(key));
    ++model_.leftOut[listed ? std::string(key) : "other statements"];
  }

  void smoothing(std::string_view group) {
    if (group != "0" && group != "off") model_.smoothingGroups = true;
  }

  void checkCount(std::size_t count) {
    if (count > kMostElements)
      failAt(lines_.number(), "is one element more than 2^31 - 1, the most that is read");
  }

  float number(std::string_view word) { return numberAt(lines_.number(), word); }
  Vec3 threeOf(Words& words) {
    Vec3 out;
    for (float& value : out) value = number(words.next());
    return out;
  }

  /// v x y z [w] [r g b]; the weight is for curves alone.
  void vertex(Words& words) {
    model_.positions.push_back(threeOf(words));
    checkCount(model_.positions.size());
    std::string_view more[4] = {};
    std::size_t count = 0;
    for (std::string_view& word : more)
      if (!(word = words.next()).empty()) ++count;
    if (count < 3) {
      if (!model_.colors.empty()) model_.colors.push_back({1, 1, 1});
      return;
    }
    Vec3 color;
    for (std::size_t i = 0; i < 3; ++i) color[i] = linearFromSrgb(number(more[count - 3 + i]));
    model_.colors.resize(model_.positions.size() - 1, {1, 1, 1});
    model_.colors.push_back(color);
  }

  void uv(Words& words) {
    const float u = number(words.next());
    const std::string_view v = words.next();
    model_.uvs.push_back({u, 1.0f - (v.empty() ? 0.0f : number(v))});
    checkCount(model_.uvs.size());
  }

  /// "3", "-1": from 0; later elements may be named too, so the end is checked last.
  std::int32_t index(std::string_view word, std::size_t there) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value == 0 ||
        value > std::int64_t(kMostElements) || -value > std::int64_t(there))
      failAt(lines_.number(), "expected an index from 1 or back from -1 to -" + std::to_string(there) +
                                  ", got " + quoted(word));
    return std::int32_t(value > 0 ? value - 1 : std::int64_t(there) + value);
  }

  Corner corner(std::string_view word) {
    Corner out{-1, -1, -1};
    const std::size_t first = word.find('/'),
                      second = first == word.npos ? word.npos : word.find('/', first + 1);
    out.position = index(word.substr(0, first), model_.positions.size());
    if (first == word.npos) return out;
    const std::string_view uv = word.substr(first + 1, second == word.npos ? word.npos : second - first - 1);
    if (!uv.empty()) out.uv = index(uv, model_.uvs.size());
    if (second != word.npos && second + 1 < word.size())
      out.normal = index(word.substr(second + 1), model_.normals.size());
    return out;
  }

  void face(Words& words) {
    const std::size_t first = model_.corners.size();
    for (std::string_view word; !(word = words.next()).empty();) model_.corners.push_back(corner(word));
    const std::size_t count = model_.corners.size() - first;
    if (count < 3) {
      model_.corners.resize(first);
      ++model_.leftOut["faces of fewer than 3 corners"];
      return;
    }
    for (std::size_t i = first; i < model_.corners.size(); ++i) highest(model_.corners[i]);
    part().faces.push_back({first, count});
  }

  /// Remembers the first line that names each highest index.
  void highest(const Corner& c) {
    const std::int32_t values[] = {c.position, c.uv, c.normal};
    for (std::size_t i = 0; i < 3; ++i)
      if (values[i] > highest_[i]) highest_[i] = values[i], highestLine_[i] = lines_.number();
  }

  void checkIndices() const {
    const std::size_t counts[] = {model_.positions.size(), model_.uvs.size(), model_.normals.size()};
    const char* names[] = {"v", "vt", "vn"};
    for (std::size_t i = 0; i < 3; ++i)
      if (highest_[i] >= std::int64_t(counts[i]))
        failAt(highestLine_[i], "names " + std::string(names[i]) + " " + std::to_string(highest_[i] + 1) +
                                    "; the file has " + std::to_string(counts[i]));
  }

  Part& part() {
    if (!part_) {
      const auto [found, isNew] = parts_.try_emplace(name_ + '\n' + material_, model_.parts.size());
      if (isNew) model_.parts.push_back({name_, material_, {}});
      part_ = &model_.parts[found->second];
    }
    return *part_;
  }

  sdk::Host& host_;
  std::size_t size_;
  Lines lines_;
  Model model_;
  std::string name_, material_;
  Part* part_ = nullptr;  // of name_ and material_; null = look it up
  std::unordered_map<std::string, std::size_t> parts_;
  std::int64_t highest_[3] = {-1, -1, -1};
  std::size_t highestLine_[3] = {};
};

}  // namespace

Model parseModel(sdk::Host& host, std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
    throw sdk::BadInput("is UTF-16 text; save it as UTF-8");
  return Parser(host, bytes).parse();
}

}  // namespace obj
