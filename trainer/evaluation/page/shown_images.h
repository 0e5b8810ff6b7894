#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trainer/evaluation/evaluate.h"

/// What the page of cps eval shows of images.
namespace cps {

/// The outputs of an image in apparent space, with the H-FOV in degrees.
struct ShownOutputs {
  Outputs truth{}, predicted{};
  std::optional<Outputs> deviation{};  ///< of the prediction
};
ShownOutputs shown_outputs(const EvaluatedImage& image);

/// What an output of ShownOutputs is called: "H-FOV, degrees", "k1, scaled", "cx / width".
std::string shown_name(int output);

/// The images that dots of a diagram stand for: all, or 2000 that are evenly chosen.
std::vector<const EvaluatedImage*> plotted_images(const Evaluation& evaluation);

/// An opacity for so many dots at which they do not hide each other.
double dot_opacity(std::size_t dots);

}  // namespace cps
