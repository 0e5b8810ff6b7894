#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "trainer/deepcalib/sphere_target.h"
#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/device.h"

namespace cps {

struct Network;

/// A trained network, loaded from its model folder.
class Predictor {
 public:
  /// Throws std::runtime_error with one line if the folder holds no complete model.
  explicit Predictor(const std::filesystem::path& model_folder, Device device = Device::cpu);

  const ModelCard& card() const { return card_; }
  /// The network with its trained weights.
  const Network& network() const { return *network_; }

  /// Runs the network on the images. Returns its outputs for each, in order, in the model's target space and
  /// natural units. The images must be those of network_image() with card().options; their sizes may differ.
  /// Throws std::runtime_error with one line for a DeepCalib head.
  std::vector<Outputs> operator()(std::span<const BatchImage> images) const;

  /// The same for a network with a DeepCalib head. Throws std::runtime_error with one line for another.
  std::vector<SphereTarget> spheres(std::span<const BatchImage> images) const;

 private:
  ModelCard card_;
  std::shared_ptr<Network> network_;
};

}  // namespace cps
