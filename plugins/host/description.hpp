// SPDX-License-Identifier: MIT
// What a plugin says about itself, checked, and as JSON for the probe's pipe and cache.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/host/library.hpp"
#include "plugins/host/plugin_host.hpp"

namespace steradian::plugins {

/// Throws std::runtime_error when an id, extension or parameter breaks the contract.
std::vector<Contribution> describe(const Library& library);

nlohmann::json toJson(const std::vector<Contribution>& contributions);
std::vector<Contribution> contributionsFromJson(
    const nlohmann::json& json);  // throws nlohmann::json::exception

/// Throws std::runtime_error when the parameter's range is empty or its default outside.
void checkParameter(const Parameter& parameter);

/// Words of letters, digits, _ and -, at least two, joined by dots.
bool isPluginId(std::string_view id);

/// Numerical by parts: "1.10.0" is above "1.9".
bool versionLess(std::string_view a, std::string_view b);

}  // namespace steradian::plugins
