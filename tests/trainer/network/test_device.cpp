#include <torch/cuda.h>

#include <catch2/catch.hpp>

#include "trainer/network/device.h"

using namespace cps;

TEST_CASE("devices are found by name") {
  CHECK(device_from_string("cpu") == Device::cpu);
  CHECK_THROWS_WITH(device_from_string("gpu"), "device 'gpu': must be cpu or cuda");
  if (torch::cuda::is_available())
    CHECK(device_from_string("cuda") == Device::cuda);
  else
    CHECK_THROWS_WITH(device_from_string("cuda"), "device 'cuda': LibTorch finds no CUDA device: use cpu");
}
