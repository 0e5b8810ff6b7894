#include "trainer/network/architectures.h"

#include <algorithm>

namespace cps {

std::span<const Architecture> architectures() {
  static const std::array<Architecture, 5> family{{
      {"resnet18", {2, 2, 2, 2}, false},
      {"resnet34", {3, 4, 6, 3}, false},
      {"resnet50", {3, 4, 6, 3}, true},
      {"resnet101", {3, 4, 23, 3}, true},
      {"resnet34-nopool", {3, 4, 6, 3}, false, false},  // the published CPS model's
  }};
  return family;
}

const Architecture* find_architecture(const std::string& name) {
  const auto all = architectures();
  const auto found = std::ranges::find(all, name, &Architecture::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace cps
