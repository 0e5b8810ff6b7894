#pragma once

namespace cps {

/// Lets LibTorch compute on so many threads; 0: on every core that this process may run on. Left alone it
/// takes one, and trains a quarter slower on two cores.
void use_threads(int threads);

}  // namespace cps
