// SPDX-License-Identifier: MIT
#include "tests/gui/driver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace steradian::test {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto kHold = 120ms;  // ImGui 1.86 samples keys and buttons once per frame

void pause(std::chrono::milliseconds time) {
  std::this_thread::sleep_for(time);
}

Process::Environment environmentFor(const Screen& screen, const fs::path& folder) {
  return {{"DISPLAY", screen.display()},
          {"STERADIAN_UI_LABELS", folder / "labels.jsonl"},
          {"STERADIAN_VALIDATION", "1"},
          {"STERADIAN_PLUGIN_PATH", STERADIAN_TEST_PLUGINS ":" STERADIAN_TEST_WAITING},
          {"XDG_STATE_HOME", folder / "state"},
          {"HOME", folder}};
}

std::vector<std::string> commandWith(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{STERADIAN_TEST_BINARY};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

}  // namespace

Driver::Driver(Screen& screen, const fs::path& folder, const std::vector<std::string>& arguments)
    : screen_(screen),
      folder_(folder),
      labels_(folder / "labels.jsonl"),
      editor_(commandWith(arguments), environmentFor(screen, folder), folder, folder / "editor.log") {
  await("viewport", 180s);
  window_ = xdotool("search --onlyvisible --class steradian | tail -1");
  if (window_.empty()) throw std::runtime_error("the editor's window cannot be found; is xdotool installed?");
  // Keys go to the active window, and the window manager may still be starting
  for (int i = 0; i < 100 && xdotool("getactivewindow 2>/dev/null") != window_; ++i) {
    xdotool("windowactivate " + window_ + " 2>/dev/null");
    pause(100ms);
  }
  pause(500ms);
}

std::string Driver::xdotool(const std::string& arguments) const {
  const std::string command = "DISPLAY=" + screen_.display() + " xdotool " + arguments;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char part[256];
  while (pipe && std::fgets(part, sizeof part, pipe)) text += part;
  if (pipe) pclose(pipe);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::optional<Area> Driver::find(const std::string& label) const {
  std::ifstream in(labels_);
  for (std::string line; std::getline(in, line);) {
    const auto entry = nlohmann::json::parse(line, nullptr, false);
    if (entry.is_discarded() || entry.at("label").get<std::string>() != label) continue;
    const auto pixels = [&](const char* key) { return int(std::lround(entry.at(key).get<double>())); };
    return Area{pixels("x"), pixels("y"), pixels("width"), pixels("height")};
  }
  return std::nullopt;
}

Area Driver::await(const std::string& label, std::chrono::seconds limit) const {
  const auto end = std::chrono::steady_clock::now() + limit;
  for (;;) {
    if (const auto area = find(label)) return *area;
    if (std::chrono::steady_clock::now() > end)
      throw std::runtime_error("'" + label + "' did not appear; the editor said: " + output());
    pause(50ms);
  }
}

std::string Driver::title() const {
  return xdotool("getwindowname " + window_);
}

bool Driver::awaitTitle(const std::string& wanted, std::chrono::seconds limit) const {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (title() != wanted) {
    if (std::chrono::steady_clock::now() > end) return false;
    pause(100ms);
  }
  return true;
}

void Driver::pointAt(const std::string& label, double across) {
  await(label);
  pause(250ms);  // a menu that just opened may still move
  const Area area = await(label);
  xdotool("mousemove --window " + window_ + " " + std::to_string(area.x + int(across * area.width)) + " " +
          std::to_string(area.y + area.height / 2));
  pause(kHold);
}

void Driver::resize(int width, int height) {
  xdotool("windowsize " + window_ + " " + std::to_string(width) + " " + std::to_string(height));
}

void Driver::click(const std::string& label, double across) {
  pointAt(label, across);
  xdotool("mousedown 1");
  pause(kHold);
  xdotool("mouseup 1");
  pause(kHold);
}

void Driver::scrollDown(const std::string& label, int notches) {
  pointAt(label, 0.1);
  xdotool("click --repeat " + std::to_string(notches) + " --delay 60 5");
  pause(300ms);
}

void Driver::doubleClick(const std::string& label) {
  pointAt(label, 0.5);
  xdotool("click --repeat 2 --delay 110 1");
  pause(kHold);
}

void Driver::key(const std::string& keys) {
  xdotool("keydown " + keys);
  pause(kHold);
  xdotool("keyup " + keys);
  pause(kHold);
}

void Driver::type(const std::string& text) {
  xdotool("type --delay 40 '" + text + "'");
  pause(kHold);
}

Image Driver::picture(const std::string& label) const {
  const Area area = await(label);
  // Where the window is on the screen: xdotool reports frame offsets wrongly, the pointer tells the truth.
  xdotool("mousemove --window " + window_ + " 0 0");
  int left = 0, top = 0;
  std::sscanf(xdotool("getmouselocation").c_str(), "x:%d y:%d", &left, &top);
  pause(300ms);
  const Image screen = screen_.read();
  Image part{area.width, area.height, 3, std::vector<float>(std::size_t(area.width) * area.height * 3)};
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x) {
      const float* from = screen.at(std::clamp(left + area.x + x, 0, screen.width - 1),
                                    std::clamp(top + area.y + y, 0, screen.height - 1));
      std::copy_n(from, 3, part.at(x, y));
    }
  return part;
}

std::string Driver::output() const {
  std::ostringstream text;
  text << std::ifstream(folder_ / "editor.log").rdbuf();
  return text.str();
}

double blockDifference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 1.0;
  double sum = 0.0;
  int blocks = 0;
  for (int y = 0; y + 8 <= a.height; y += 8)
    for (int x = 0; x + 8 <= a.width; x += 8, ++blocks) {
      double difference = 0.0;
      for (int i = 0; i < 64 * 3; ++i)
        difference += a.at(x + i / 3 % 8, y + i / 24)[i % 3] - b.at(x + i / 3 % 8, y + i / 24)[i % 3];
      sum += std::abs(difference) / (64 * 3);
    }
  return blocks ? sum / blocks : 0.0;
}

}  // namespace steradian::test
