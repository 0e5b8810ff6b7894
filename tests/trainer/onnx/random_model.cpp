#include "tests/trainer/onnx/random_model.h"

#include <torch/types.h>
#include <torch/utils.h>

#include <cmath>

#include "numbers/angles.h"
#include "tests/trainer/street.h"
#include "trainer/model/make_network.h"
#include "trainer/model/model_card.h"
#include "trainer/network/weights.h"

namespace cps {
namespace {

/// Random values for every weight that training would change.
void randomise(Network& network, bool bottleneck) {
  const torch::NoGradGuard no_gradients;
  const std::string last_of_block = bottleneck ? ".bn3.weight" : ".bn2.weight";
  for (auto& [name, tensor] : weights_of(network)) {
    if (name.ends_with("running_mean"))
      tensor.normal_(0, .2);
    else if (name.ends_with("running_var"))
      tensor.uniform_(.5, 2);
    else if (name == "fc.weight")
      tensor.normal_(0, .5 / std::sqrt(static_cast<double>(tensor.size(1))));
    else if (name.ends_with(last_of_block))
      tensor.uniform_(.1, .3);  // else a deep network's features grow from block to block
    else if (tensor.dim() == 1 && name.ends_with(".weight"))
      tensor.uniform_(.5, 1.5);
    else if (name.ends_with(".bias"))
      tensor.normal_(0, .1);
  }
}

/// Another mean and deviation for every plane and number.
OrientationStatistics some_orientation() {
  OrientationStatistics statistics;
  for (int i = 0; i < orientation_plane_count; ++i) {
    statistics.plane_mean[i] = .01 * (i - 1);
    statistics.plane_deviation[i] = .02 * (i + 1);
  }
  for (int i = 0; i < orientation_number_count; ++i) {
    statistics.number_mean[i] = .003 * (i - 10);
    statistics.number_deviation[i] = .02 + .01 * i;
  }
  return statistics;
}

}  // namespace

void write_random_model(const std::filesystem::path& folder, const TrainOptions& options) {
  torch::manual_seed(static_cast<std::uint64_t>(options.seed));
  const auto network = make_network(options);
  randomise(*network, find_architecture(options.architecture)->bottleneck);
  save_tensors(weights_of(*network), folder / "weights.pt");
  save_model_card({.options = options,
                   .pixels = {.mean = 111.7, .deviation = 57.3},
                   .orientation = some_orientation(),
                   .targets = {.mean = {1.3, -.08, .02, -.003, .0004, -.0003, .503, .497},
                               .deviation = {.15, .1, .05, .02, .002, .003, .02, .03}},
                   .dataset = "data",
                   .dataset_hash = "0123456789abcdef",
                   .training_images = 8,
                   .validation_images = 4,
                   .epoch = 3,
                   .validation_loss = .25},
                  folder);
}

std::array<double, output_count> label_numbers(const CalibratedCamera& camera) {
  const Distortion& d = camera.distortion;
  return {
      degrees(hfov_rad(camera.pinhole)), d.k1, d.k2, d.k3, d.p1, d.p2, camera.pinhole.cx, camera.pinhole.cy};
}

GrayImage numbered_street(int height, int number) {
  const auto place = static_cast<std::uint64_t>(number);
  return render_street(draw_calibration({96, height}, 50 + 20 * number, place), place);
}

}  // namespace cps
