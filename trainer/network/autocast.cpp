#include "trainer/network/autocast.h"

#include <ATen/autocast_mode.h>

namespace cps {
namespace {

/// For tensors on either device.
void set_enabled(bool enabled) {
  at::autocast::set_cpu_enabled(enabled);
  at::autocast::set_enabled(enabled);
  // A pass uses each weight once. Kept copies would be those of weights that a step has since changed.
  at::autocast::set_autocast_cache_enabled(!enabled);
}

}  // namespace

Autocast::Autocast(Precision precision) : is_on_(precision == Precision::bfloat16) {
  if (!is_on_) return;
  at::autocast::set_autocast_cpu_dtype(torch::kBFloat16);
  at::autocast::set_autocast_gpu_dtype(torch::kBFloat16);
  set_enabled(true);
}

Autocast::~Autocast() {
  if (is_on_) set_enabled(false);
}

void use_channels_last(torch::nn::Module& network) {
  const torch::NoGradGuard no_gradients;
  for (torch::Tensor& parameter : network.parameters())
    if (parameter.dim() == 4)
      parameter.set_data(
          parameter.detach().to(parameter.options(), false, false, at::MemoryFormat::ChannelsLast));
}

}  // namespace cps
