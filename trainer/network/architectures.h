#pragma once

#include <array>
#include <span>
#include <string>

namespace cps {

/// A network of the ResNet family (He et al. 2016, table 1), or a variant. A name that ends in -32 or -16 is
/// so wide, not 64.
struct Architecture {
  std::string name;
  std::array<int, 4> blocks;  ///< in layer1 … layer4
  bool bottleneck = false;    ///< blocks of 1×1, 3×3, 1×1 with fourfold output channels, not 3×3, 3×3
  bool max_pool = true;       ///< after the first convolution; without it every feature map is twice as large
  int width = 64;             ///< channels after the first convolution; each later stage doubles them
};

/// All known architectures.
std::span<const Architecture> architectures();

/// The architecture of that name; null if there is none.
const Architecture* find_architecture(const std::string& name);

}  // namespace cps
