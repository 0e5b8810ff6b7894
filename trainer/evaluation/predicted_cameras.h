#pragma once

#include <optional>
#include <span>
#include <vector>

#include "trainer/model/predictor.h"

/// Predictions of any head as cameras, for images of their original size. They have no names.
namespace cps {

/// The camera of a brown_conrady head's outputs, see to_camera(); empty if they are none.
std::optional<ModelCamera> predicted_camera(const Outputs& outputs, TargetSpace space, const ImageSize& size);

/// Runs the network: a camera for each image, of the lens family that its head says.
std::vector<std::optional<ModelCamera>> predicted_cameras(const Predictor& predictor,
                                                          std::span<const BatchImage> images);

/// What the mean of the training targets says of an image of this size, without having seen it.
std::optional<ModelCamera> training_mean_camera(const ModelCard& card, const ImageSize& size);

}  // namespace cps
