// SPDX-License-Identifier: MIT
// Where the bytes come from: the BIN chunk, data URIs and files beside the imported one; nowhere else.
#pragma once
#include "container.hpp"

namespace gltf {

/// %41 -> A. Throws BadInput for broken escapes.
std::string percentDecoded(std::string_view uri);
/// The bytes of "data:...;base64,...". Throws BadInput when it is no such URI.
std::string dataUriBytes(std::string_view uri);

/// Reads what `uri` names: a data URI or a relative path. Throws BadInput "buffers[0].uri: ...".
std::string_view bytesOf(sdk::Host& host, const std::string& uri, const std::string& place,
                         std::deque<std::string>& decoded);

/// All buffers of a checked JSON, each as long as its byteLength. Throws BadInput with the place of the first
/// that is missing or short. Buffers that only stand in for compressed views are empty.
std::vector<std::string_view> loadBuffers(sdk::Host& host, const Json& json, const Container& container,
                                          std::deque<std::string>& decoded);

/// All images; those that cannot be read carry the reason. `view(index)` gives a buffer view's bytes or
/// throws BadInput.
template <class View>
std::vector<ImageBytes> loadImages(sdk::Host& host, const Json& json, View&& view, const Unsound& unsound,
                                   std::deque<std::string>& decoded) {
  std::vector<ImageBytes> out;
  const Json none = Json::array();
  for (const Json& image : json.contains("images") ? json["images"] : none) {
    const std::string place = at("images", out.size());
    ImageBytes& each = out.emplace_back();
    each.name = image.value("name", "");
    try {
      if (const auto bad = unsound.find(place); bad != unsound.end()) throw sdk::BadInput(bad->second);
      if (image.contains("bufferView"))
        each.bytes = view(image["bufferView"].template get<std::size_t>());
      else if (image.contains("uri"))
        each.bytes = bytesOf(host, image["uri"], place + ".uri", decoded);
      else
        throw sdk::BadInput(place + ": expected a uri or a bufferView");
      if (each.bytes.empty()) throw sdk::BadInput(place + ": is empty");
    } catch (const sdk::BadInput& error) {
      each.error = error.what();
    }
    const std::string uri = image.value("uri", "");
    if (each.name.empty() && uri.size() < 256 && uri.rfind("data:", 0) != 0) each.name = uri;
  }
  return out;
}

}  // namespace gltf
