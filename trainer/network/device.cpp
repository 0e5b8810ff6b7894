#include "trainer/network/device.h"

#include <c10/core/Device.h>
#include <torch/cuda.h>

#include <stdexcept>

namespace cps {

Device device_from_string(const std::string& word) {
  if (word == "cpu") return Device::cpu;
  if (word != "cuda") throw std::runtime_error("device '" + word + "': must be cpu or cuda");
  if (!torch::cuda::is_available())
    throw std::runtime_error("device 'cuda': LibTorch finds no CUDA device: use cpu");
  return Device::cuda;
}

c10::Device to_torch(Device device) {
  return device == Device::cuda ? c10::Device(c10::kCUDA) : c10::Device(c10::kCPU);
}

}  // namespace cps
