#pragma once

#include <string>

#include "trainer/evaluation/evaluate.h"

/// The sections of the page of cps eval, as HTML. All text from outside is escaped. Of a set of any size they
/// show a bounded number of dots and pictures.
namespace cps {

/// Predicted against true values of the eight outputs, with the stated deviations where there are any.
std::string predicted_section(const Evaluation& evaluation);

/// Whether the stated deviations are those of the errors. Nothing without deviations.
std::string reliability_section(const Evaluation& evaluation);

/// Errors by H-FOV and by the strength of the lens, beside those of the training mean.
std::string error_section(const Evaluation& evaluation);

/// The joint fit of each camera beside its single images. Nothing unless EvaluationOptions::per_camera.
std::string camera_section(const Evaluation& evaluation);

/// Pictures with the edges that the network trusts. Nothing without a fit.
std::string edge_section(const Evaluation& evaluation);

/// The pictures with the largest reprojection errors: true and predicted numbers and lenses.
std::string failure_section(const Evaluation& evaluation);

}  // namespace cps
