// SPDX-License-Identifier: MIT
// The host's side of one import or export: services, parameters, the bytes written, and the verdict.
#include "plugins/host/call.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/host/read_file.hpp"
#include "plugins/host/utf8.hpp"

namespace steradian::plugins {

namespace {

constexpr std::uint64_t kLargestBeside = 4ull << 30;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

double checkedValue(const Parameter& parameter, double value, const std::string& plugin) {
  const bool boolean = parameter.type == Parameter::Type::boolean;
  const double low = boolean ? 0 : parameter.minimum, high = boolean ? 1 : parameter.maximum;
  const bool whole = parameter.type == Parameter::Type::real || value == std::floor(value);
  if (value >= low && value <= high && whole) return value;
  throw Error(ExitCode::usage, plugin + ": parameter '" + parameter.id + "' is " + number(value) +
                                   "; expected " +
                                   (parameter.type == Parameter::Type::real ? "a number" : "a whole number") +
                                   " from " + number(low) + " to " + number(high));
}

/// A message may quote the file, bad bytes and line ends included; what the user sees is one line of valid
/// text.
std::string oneLine(std::string text) {
  const bool valid = isUtf8(text);
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || (!valid && static_cast<unsigned char>(c) > 0x7e)) c = '?';
  return text;
}

}  // namespace

Call::Call(const Contribution& contribution, const std::filesystem::path& file, const Progress& progress,
           const Parameters& parameters)
    : contribution_(contribution), path_(file), file_(file.string()), progress_(progress) {
  std::string known;
  for (const Parameter& p : contribution.parameters) {
    values_[p.id] = p.defaultValue;
    known += (known.empty() ? "" : ", ") + p.id;
  }
  for (const auto& [id, value] : parameters) {
    const auto p = std::find_if(contribution.parameters.begin(), contribution.parameters.end(),
                                [&, &id = id](const Parameter& each) { return each.id == id; });
    if (p == contribution.parameters.end())
      throw Error(ExitCode::usage, contribution.id + " has no parameter '" + id + "'; it has " +
                                       (known.empty() ? "none" : known));
    values_[id] = checkedValue(*p, value, contribution.id);
  }
}

template <class Work>
void Call::keeping(Work&& work) noexcept try {
  work();
} catch (...) {
  ours_ = std::current_exception();
}

void Call::log(sdk::Text message) noexcept {
  keeping([&] {
    if (progress_.log) progress_.log(file_ + ": " + oneLine(message.str()));
  });
}

void Call::progress(double fraction) noexcept {
  keeping([&] {
    if (progress_.report) progress_.report(std::clamp(fraction, 0.0, 1.0));
  });
}

bool Call::cancelled() noexcept {
  bool yes = ours_ != nullptr;
  keeping([&] { yes = yes || (progress_.cancelled && progress_.cancelled()); });
  return yes;
}

void Call::fail(sdk::Text message) noexcept {
  keeping([&] { message_ = oneLine(message.str()); });
}

double Call::parameter(sdk::Text id) noexcept {
  double value = 0;
  keeping([&] {
    const auto found = values_.find(id.str());
    if (found != values_.end()) value = found->second;
  });
  return value;
}

void Call::notKept(sdk::Text what, sdk::Text why) noexcept {
  keeping([&] { report.notKept.push_back({what.str(), why.str()}); });
}

bool Call::readBeside(sdk::Text path, sdk::Text& bytes) noexcept {
  bool read = false;
  keeping([&] {
    try {
      beside_.push_back(readFile(insideFolder(path_.parent_path(), path.str()), kLargestBeside));
      read = true;
    } catch (const Error& error) {
      beside_.push_back(error.what());
    }
    bytes = beside_.back();
  });
  return read;
}

void Call::judge(sdk::Status status) const {
  if (ours_) std::rethrow_exception(ours_);
  switch (status) {
    case sdk::Status::ok:
      return;
    case sdk::Status::badInput:
      throw Error(ExitCode::badInput, file_ + ": " + message_);
    case sdk::Status::cancelled:
      throw Error(ExitCode::failed, file_ + ": cancelled");
    case sdk::Status::failed:
      break;
  }
  throw Error(ExitCode::plugin, file_ + ": plugin " + contribution_.id + " " + contribution_.version +
                                    " failed: " + (message_.empty() ? "it gave no reason" : message_));
}

void MemoryWriter::writeBeside(sdk::Text path, const void* data, std::uint64_t size) noexcept try {
  beside[path.str()].assign(static_cast<const char*>(data), size);
} catch (const std::exception&) {
  outOfMemory = true;
}

void MemoryWriter::write(const void* data, std::uint64_t size) noexcept try {
  bytes.append(static_cast<const char*>(data), size);
} catch (const std::exception&) {
  outOfMemory = true;
}

}  // namespace steradian::plugins
