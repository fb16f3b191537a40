// SPDX-License-Identifier: MIT
// Reading of one object or material, and the texts that its record points into.
#pragma once
#include <deque>

#include "fields.hpp"
#include "project.hpp"

namespace project {

/// Records point into these texts until the sink has copied them.
class Texts {
 public:
  steradian::sdk::Text keep(std::string text) { return texts_.emplace_back(std::move(text)); }
  steradian::sdk::Text read(Fields& fields, const char* key) {
    std::string text;
    fields.readText(key, text);
    return keep(std::move(text));
  }

 private:
  std::deque<std::string> texts_;
};

steradian::sdk::ObjectRecord readObject(Fields& fields, Texts& texts);
steradian::sdk::MaterialRecord readMaterial(Fields& fields, Texts& texts);

}  // namespace project
