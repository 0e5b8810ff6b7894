#include "trainer/evaluation/page/shown_images.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "numbers/angles.h"

namespace cps {

ShownOutputs shown_outputs(const EvaluatedImage& image) {
  ShownOutputs shown{.truth = to_outputs(image.image.truth, TargetSpace::apparent),
                     .deviation = image.apparent_deviation};
  for (int i = 0; i < output_count; ++i) shown.predicted[i] = shown.truth[i] + image.network.apparent[i];
  for (Outputs* outputs : {&shown.truth, &shown.predicted}) (*outputs)[0] = degrees((*outputs)[0]);
  if (shown.deviation) (*shown.deviation)[0] = degrees((*shown.deviation)[0]);
  return shown;
}

std::string shown_name(int output) {
  static constexpr std::array names{"H-FOV, degrees", "k1, scaled", "k2, scaled", "k3, scaled",
                                    "p1, scaled",     "p2, scaled", "cx / width", "cy / height"};
  return names[output];
}

std::vector<const EvaluatedImage*> plotted_images(const Evaluation& evaluation) {
  constexpr std::size_t max_images = 2000;
  const std::size_t all = evaluation.images.size(), count = std::min(max_images, all);
  std::vector<const EvaluatedImage*> images;
  for (std::size_t i = 0; i < count; ++i) images.push_back(&evaluation.images[i * all / count]);
  return images;
}

double dot_opacity(std::size_t dots) {
  return std::clamp(7 / std::sqrt(static_cast<double>(dots) + 1), .12, .5);
}

}  // namespace cps
