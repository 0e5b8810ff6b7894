#include "trainer/network/architectures.h"

#include <algorithm>

namespace cps {

std::span<const Architecture> architectures() {
  static const std::array<Architecture, 8> family{{
      {"resnet18", {2, 2, 2, 2}, false},
      {"resnet34", {3, 4, 6, 3}, false},
      {"resnet50", {3, 4, 6, 3}, true},
      {"resnet101", {3, 4, 23, 3}, true},
      {"resnet34-nopool", {3, 4, 6, 3}, false, false},  // the published CPS model's
      {.name = "resnet18-32", .blocks = {2, 2, 2, 2}, .width = 32},
      {.name = "resnet18-16", .blocks = {2, 2, 2, 2}, .width = 16},
      {.name = "resnet10-32", .blocks = {1, 1, 1, 1}, .width = 32},
  }};
  return family;
}

const Architecture* find_architecture(const std::string& name) {
  const auto all = architectures();
  const auto found = std::ranges::find(all, name, &Architecture::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace cps
