#include "trainer/evaluation/evaluated_image.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cps {

LensErrors summary_of(std::span<const EvaluatedImage> images, std::span<const int> chosen,
                      ImageErrors EvaluatedImage::*of) {
  std::vector<ImageErrors> errors;
  std::vector<double> fov;
  for (int i : chosen) {
    errors.push_back(images[i].*of);
    fov.push_back(hfov_rad(images[i].image.truth.pinhole));
  }
  return summarise(errors, fov);
}

std::vector<int> by_reprojection_error(std::span<const EvaluatedImage> images) {
  std::vector<int> order(images.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {},
                           [&](int i) { return images[i].network.reprojection_px.value_or(INFINITY); });
  return order;
}

}  // namespace cps
