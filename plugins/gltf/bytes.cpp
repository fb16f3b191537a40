// SPDX-License-Identifier: MIT
// Where the bytes come from: the BIN chunk, data URIs and files beside the imported one; nowhere else.
#include "bytes.hpp"

namespace gltf {

namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = char(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;  // also RFC 4648's URL alphabet
  return c == '/' || c == '_' ? 63 : -1;
}

std::string base64Decoded(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = base64Digit(c);
    if (digit < 0) throw sdk::BadInput("has a character that is not base64");
    bits = (bits << 6) | std::uint32_t(digit);
    if ((held += 6) < 8) continue;
    held -= 8;
    out += char(bits >> held & 0xff);
  }
  return out;
}

/// "http:" and the like; one letter could be a drive of Windows, no path of ours either.
bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find_first_of(":/?#");
  return colon != uri.npos && uri[colon] == ':';
}

bool standsInForCompressed(const Json& buffer) {
  const auto extensions = buffer.find("extensions");
  return extensions != buffer.end() && extensions->contains("EXT_meshopt_compression");
}

std::string_view loadBuffer(sdk::Host& host, const Json& buffer, const std::string& place, bool first,
                            const Container& container, std::deque<std::string>& decoded) {
  std::string_view bytes;
  if (buffer.contains("uri"))
    bytes = bytesOf(host, buffer["uri"], place + ".uri", decoded);
  else if (first && container.hasBinary)
    bytes = container.binary;
  else if (standsInForCompressed(buffer))
    return {};
  else
    throw sdk::BadInput(place + ".uri: expected it, because the file has no BIN chunk for this buffer");
  const auto length = buffer["byteLength"].get<std::uint64_t>();
  if (length > bytes.size())
    throw sdk::BadInput(place + ".byteLength: expected at most " + std::to_string(bytes.size()) +
                        ", the bytes there are, got " + std::to_string(length));
  return bytes.substr(0, length);
}

}  // namespace

std::string percentDecoded(std::string_view uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      out += uri[i];
      continue;
    }
    const int high = i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
    const int low = i + 2 < uri.size() ? hexDigit(uri[i + 2]) : -1;
    if (high < 0 || low < 0) throw sdk::BadInput("has a % that is not followed by two hexadecimal digits");
    out += char(high * 16 + low);
    i += 2;
  }
  return out;
}

std::string dataUriBytes(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos) throw sdk::BadInput("is a data URI without a comma");
  const std::string_view head = uri.substr(0, comma), body = uri.substr(comma + 1);
  const bool base64 = head.size() >= 7 && head.substr(head.size() - 7) == ";base64";
  return base64 ? base64Decoded(body) : percentDecoded(body);
}

std::string_view bytesOf(sdk::Host& host, const std::string& uri, const std::string& place,
                         std::deque<std::string>& decoded) {
  try {
    if (uri.rfind("data:", 0) == 0) return decoded.emplace_back(dataUriBytes(uri));
    if (hasScheme(uri)) throw sdk::BadInput("'" + uri + "' is not a path; expected a file beside this one");
    sdk::Text bytes;
    if (!host.readBeside(percentDecoded(uri), bytes)) throw sdk::BadInput(bytes.str());
    return bytes.view();
  } catch (const sdk::BadInput& error) {
    throw sdk::BadInput(place + ": " + error.what());
  }
}

std::vector<std::string_view> loadBuffers(sdk::Host& host, const Json& json, const Container& container,
                                          std::deque<std::string>& decoded) {
  std::vector<std::string_view> out;
  const auto buffers = json.find("buffers");
  if (buffers == json.end()) return out;
  for (const Json& buffer : *buffers)
    out.push_back(loadBuffer(host, buffer, at("buffers", out.size()), out.empty(), container, decoded));
  return out;
}

}  // namespace gltf
