#pragma once

#include <torch/nn/module.h>

#include "trainer/network/precision.h"

namespace cps {

/// While it lives, the convolutions and matrix products of this thread compute in `precision` (automatic
/// mixed precision, Micikevicius et al. 2018): for bfloat16 they round their inputs and weights to it and
/// return it; batch normalisation and the like follow their input. The backward pass, which is started
/// outside, uses the same formats. Any other precision changes nothing.
class Autocast {
 public:
  explicit Autocast(Precision precision);
  ~Autocast();
  Autocast(const Autocast&) = delete;
  Autocast& operator=(const Autocast&) = delete;

 private:
  bool is_on_;
};

/// Stores the kernels of convolutions with their channels innermost, which is fastest for bfloat16; images
/// and gradients follow. Values, names and files stay the same.
void use_channels_last(torch::nn::Module& network);

}  // namespace cps
