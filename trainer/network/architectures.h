#pragma once

#include <array>
#include <span>
#include <string>

namespace cps {

/// A member of the ResNet family (He et al. 2016, table 1), or a relative.
struct Architecture {
  std::string name;
  std::array<int, 4> blocks;  ///< in layer1 … layer4
  bool bottleneck = false;    ///< 1×1, 3×3, 1×1 with four times the channels out, rather than 3×3, 3×3
  bool max_pool = true;       ///< after the first convolution; without it every map is twice as large
};

/// All that can be asked for by name.
std::span<const Architecture> architectures();

/// Null when there is none of that name.
const Architecture* find_architecture(const std::string& name);

}  // namespace cps
