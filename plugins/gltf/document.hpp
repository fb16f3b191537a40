// SPDX-License-Identifier: MIT
// A glTF file in memory once it is known to be sound enough to walk: typed model, bytes, and what is wrong
// with parts.
#pragma once
#include <deque>
#include <map>
#include <steradian/plugin.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tinygltf.hpp"

namespace gltf {

namespace sdk = steradian::sdk;
using Json = nlohmann::json;

/// Places in the file and what is wrong there: "accessors[3]" -> "accessors[3].byteOffset: expected ...".
using Unsound = std::map<std::string, std::string>;

/// Where an image's encoded bytes are; `error` says why there are none.
struct ImageBytes {
  std::string name;
  std::string_view bytes;
  std::string error;
};

struct Document {
  tinygltf::Model model;  // every index is in range, every number finite; buffers and images empty
  std::vector<std::string_view> buffers;  // as long as their byteLength
  std::vector<ImageBytes> images;
  Unsound unsound;
  std::deque<std::string> decoded;  // bytes that are ours: data URIs, decompressed views

  /// Throws BadInput with the reason when the element at `place` is unsound.
  void demand(const std::string& place) const {
    if (const auto found = unsound.find(place); found != unsound.end()) throw sdk::BadInput(found->second);
  }
};

/// "accessors[3]"
inline std::string at(std::string_view list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

/// What the user reads as the name of an element: "mesh 'Cube'", "mesh 3".
inline std::string named(const char* kind, const std::string& name, std::size_t index) {
  return std::string(kind) + " " + (name.empty() ? std::to_string(index) : "'" + name + "'");
}

/// The import report.
class Report {
 public:
  explicit Report(sdk::Host& host) : host_(host) {}
  void approximated(const std::string& what, const std::string& how) {
    host_.notKept(what, "approximated: " + how);
  }
  void dropped(const std::string& what, const std::string& why) { host_.notKept(what, "left out: " + why); }
  void exact(const std::string& what, const std::string& note) { host_.notKept(what, note); }

  /// Runs `work`; what it finds wrong costs `what` only. False when it did.
  template <class Work>
  bool attempt(const std::string& what, Work&& work) {
    try {
      work();
      return true;
    } catch (const sdk::BadInput& error) {
      dropped(what, error.what());
      return false;
    }
  }

 private:
  sdk::Host& host_;
};

}  // namespace gltf
