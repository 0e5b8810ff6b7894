#pragma once

namespace cps {

/// Sets the number of LibTorch's threads; 0: all cores that this process may run on. LibTorch's default is
/// one thread, with which training on two cores is a quarter slower.
void use_threads(int threads);

}  // namespace cps
