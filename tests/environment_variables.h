#pragma once

#include <cstdlib>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace cps {

/// Sets variables of the environment, which were not set, as long as it lives.
struct EnvironmentVariables {
  std::vector<std::string> names;
  EnvironmentVariables(std::initializer_list<std::pair<const char*, const char*>> values) {
    for (const auto& [name, value] : values) {
      names.push_back(name);
      setenv(name, value, 1);
    }
  }
  ~EnvironmentVariables() {
    for (const std::string& name : names) unsetenv(name.c_str());
  }
  EnvironmentVariables(const EnvironmentVariables&) = delete;
};

}  // namespace cps
