#pragma once

#include <array>
#include <filesystem>

#include "distortion/calibrated_camera.h"
#include "trainer/calibration/targets.h"
#include "trainer/images/gray_image.h"
#include "trainer/model/train_options.h"

namespace cps {

/// Writes a model folder: the network that the options describe, with random weights, factors and statistics
/// of batch normalisation, pixels and targets. Its predictions differ from image to image and are cameras.
void write_random_model(const std::filesystem::path& folder, const TrainOptions& options);

/// The camera's numbers as they stand in calibration.json: degrees, coefficients, pixels.
std::array<double, output_count> label_numbers(const CalibratedCamera& camera);

/// A street (tests/trainer/street.h) of 96×`height` pixels, another for each number.
GrayImage numbered_street(int height, int number);

}  // namespace cps
