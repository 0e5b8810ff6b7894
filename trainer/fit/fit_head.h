#pragma once

#include <torch/types.h>

#include <span>
#include <vector>

#include "trainer/calibration/lens_posterior.h"
#include "trainer/fit/lens_fit.h"
#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/resnet.h"

/// From what a network says of a batch to what its head says of it: with a fit, the numbers that the network
/// reads directly are a normal prior, the edges are measurements whose precisions are the network's weights,
/// and the result is the posterior (fit_lens()).
namespace cps {

/// What the fit gets of each image. `images` must be those that `output` was computed from; the card's head
/// must be one with a fit (not checked).
std::vector<FrameEvidence> frame_evidence(const NetworkOutput& output, std::span<const BatchImage> images,
                                          const ModelCard& card);

/// [n, row_width(head)] float. Without a fit, the network's numbers. With one, the eight standardised outputs
/// and their covariance, row by row, of lenses fitted on the CPU; differentiable: fit_lens() finds the
/// parameters, and one more step of Gauss and Newton from there, of which only the gradient is taken, carries
/// how they depend on weights and prior. The model's slopes are taken as fixed: of the parameters' gradient
/// that leaves out little, of the covariance's it leaves out how the slopes move with the fit.
torch::Tensor head_rows(const NetworkOutput& output, std::span<const BatchImage> images,
                        const ModelCard& card);

/// The mean and covariance in a row of head_rows() with a fit, in the model's target space and natural units,
/// with standard deviations multiplied by card.deviation_scale, and the H-FOV within fitted_hfov_rad.
LensPosterior posterior_of(std::span<const float> row, const ModelCard& card);

/// The training loss of such rows beside the outputs' own: half the mean of error²/variance + log variance
/// over the outputs, standardised (the negative log likelihood of independent normal numbers).
torch::Tensor likelihood_loss(const torch::Tensor& rows, const torch::Tensor& truth);

/// A penalty on lenses that fold within the frame of the true lens: the mean squared lack of the radial slope
/// below .15 at eight radii, up to where the true lens shows the corner. rows: head_rows() with a fit; truth:
/// the true outputs, not standardised.
torch::Tensor folding_penalty(const torch::Tensor& rows, std::span<const Outputs> truth,
                              const Standardisation& by);

/// The factors on the stated standard deviations that make them hold 68.27 % of the errors of these images,
/// for each output. rows: head_rows() with a fit; truth: as above. 1 without images.
Outputs deviation_scale(const torch::Tensor& rows, std::span<const Outputs> truth, const Standardisation& by);

}  // namespace cps
