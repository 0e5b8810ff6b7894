#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "trainer/calibration/lens_posterior.h"
#include "trainer/deepcalib/sphere_target.h"
#include "trainer/fit/lens_fit.h"
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
  /// natural units; those of a head with a fit are pulled_to_one_to_one(). The images must be those of
  /// network_image() with card().options; their sizes may differ. Throws std::runtime_error with one line for
  /// a DeepCalib head.
  std::vector<Outputs> operator()(std::span<const BatchImage> images) const;

  /// The same outputs with their covariance, which is that before they are pulled, of a network whose head
  /// has a fit. Throws std::runtime_error with one line for another.
  std::vector<LensPosterior> posteriors(std::span<const BatchImage> images) const;

  /// What the fit of such a network gets of each image. Throws as posteriors() does.
  std::vector<FrameEvidence> evidence(std::span<const BatchImage> images) const;

  /// As operator(), for a network with a DeepCalib head. Throws std::runtime_error with one line for another.
  std::vector<SphereTarget> spheres(std::span<const BatchImage> images) const;

 private:
  void require_fit() const;

  ModelCard card_;
  std::shared_ptr<Network> network_;
};

}  // namespace cps
