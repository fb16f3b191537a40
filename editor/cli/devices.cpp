// SPDX-License-Identifier: MIT
// steradian devices: what could render here, and which one would.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/commands.hpp"
#include "renderer/renderer.hpp"

namespace steradian::cli {

namespace {

void printJson(const std::vector<DeviceDescription>& devices) {
  auto list = nlohmann::ordered_json::array();
  for (const DeviceDescription& device : devices)
    list.push_back({{"index", device.index},
                    {"name", device.name},
                    {"type", device.type},
                    {"driver", device.driver},
                    {"api", device.api},
                    {"queues", device.queues},
                    {"usable", device.usable},
                    {"reason", device.reason},
                    {"chosen", device.chosen}});
  std::puts(list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

void printText(const std::vector<DeviceDescription>& devices) {
  for (const DeviceDescription& device : devices) {
    std::printf("%c %d  %s\n", device.chosen ? '*' : ' ', device.index, device.name.c_str());
    std::printf("     %s, Vulkan %s, %s\n", device.type.c_str(), device.api.c_str(), device.driver.c_str());
    if (device.usable)
      std::printf("     %s\n", device.queues.c_str());
    else
      std::printf("     not usable: %s\n", device.reason.c_str());
  }
}

}  // namespace

void addDevices(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("devices", "List the Vulkan devices; * marks the one that is used");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Machine-readable output");
  command->callback([json, &chosen] {
    chosen = [json] {
      const auto devices = describeDevices();
      *json ? printJson(devices) : printText(devices);
      return 0;
    };
  });
}

}  // namespace steradian::cli
