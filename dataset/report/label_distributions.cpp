#include "dataset/report/label_distributions.h"

#include <algorithm>
#include <cmath>

#include "distortion/certificate/displacement.h"
#include "numbers/angles.h"

namespace cps {
namespace {

/// A number of a label, and its limits in a recipe.
struct LabelNumber {
  const char *name, *unit, *note;
  bool needs_lens;  ///< leave out images without one
  double (*of)(const Label& label);
  std::optional<Interval> (*limits)(const Recipe& recipe);  ///< nullptr: none
};

std::optional<Interval> hull(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(values);
  return Interval{low, high};
}

/// NaN where the label's base is no camera, which cps verify reports.
double displacement_percent(const Label& label) {
  if (!(label.fov_base_deg > 0 && label.fov_base_deg < 179)) return NAN;
  return 100 * largest_displacement(label.distortion, frame_on_plane(base_of(label)));
}

double shift_x_percent(const Label& label) {
  return 100 * (label.camera.cx - 0.5 * (label.camera.width - 1)) / label.camera.width;
}
double shift_y_percent(const Label& label) {
  return 100 * (label.camera.cy - 0.5 * (label.camera.height - 1)) / label.camera.height;
}

constexpr const char* drawn_note = "Limits: from the lowest to the highest that any lens was drawn between";

constexpr LabelNumber label_numbers[] = {
    {"H-FOV", "degrees", "", false, [](const Label& l) { return degrees(hfov_rad(l.camera)); },
     [](const Recipe& r) { return hull(r.hfov_deg); }},
    {"H-FOV before the crop", "degrees", "", false, [](const Label& l) { return l.fov_base_deg; },
     [](const Recipe& r) { return hull(r.base_hfov_deg); }},
    {"H-FOV really shown", "degrees", "", false, [](const Label& l) { return l.fov_true_h_deg; }, nullptr},
    {"k1", "", drawn_note, true, [](const Label& l) { return l.distortion.k1; }, nullptr},
    {"k2", "", drawn_note, true, [](const Label& l) { return l.distortion.k2; }, nullptr},
    {"k3", "", drawn_note, true, [](const Label& l) { return l.distortion.k3; }, nullptr},
    {"p1", "", drawn_note, true, [](const Label& l) { return l.distortion.p1; }, nullptr},
    {"p2", "", drawn_note, true, [](const Label& l) { return l.distortion.p2; }, nullptr},
    {"cx, from the image's centre", "% of the width", "", true, shift_x_percent,
     [](const Recipe& r) {
       const double most = 100 * r.lens_options.principal_point.max_shift_x;
       return std::optional(Interval{-most, most});
     }},
    {"cy, from the image's centre", "% of the height", "", true, shift_y_percent,
     [](const Recipe& r) {
       const double most = 100 * r.lens_options.principal_point.max_shift_y;
       return std::optional(Interval{-most, most});
     }},
    {"largest displacement by the lens", "% of the half diagonal", "", true, displacement_percent,
     [](const Recipe& r) {
       return std::optional(Interval{0, 100 * r.lens_options.bounds.max_displacement});
     }},
    {"smallest local scale of the lens", "", "", true,
     [](const Label& l) { return l.certificate_min_eigenvalue; },
     [](const Recipe& r) {
       return std::optional(Interval{r.lens_options.bounds.min_eigenvalue, 1});
     }},
    {"zoom of the crop", "", "", true, [](const Label& l) { return l.zoom; },
     [](const Recipe& r) {
       return std::optional(Interval{1, r.lens_options.principal_point.max_zoom});
     }},
};

/// From the lowest to the highest limit in the labels of `key`. Empty unless every lens names some: others
/// are drawn by a prior, beyond those intervals.
std::optional<Interval> drawn_limits(const Dataset& dataset, const std::string& key) {
  const auto k = std::ranges::find(lens_keys, key) - lens_keys.begin();
  std::optional<Interval> limits;
  if (k == static_cast<std::ptrdiff_t>(lens_keys.size())) return limits;
  for (const DatasetGroup& group : dataset.groups) {
    if (is_undistorted(group.label)) continue;
    const auto& own = group.label.limits[k];
    if (!own) return std::nullopt;
    if (!limits) limits = own;
    limits = Interval{std::min(limits->low, own->low), std::max(limits->high, own->high)};
  }
  return limits;
}

}  // namespace

bool is_undistorted(const Label& label) {
  return label.distortion == Distortion{};
}

std::vector<Distribution> label_distributions(const Dataset& dataset, const std::optional<Recipe>& recipe) {
  std::vector<Distribution> distributions;
  for (const LabelNumber& number : label_numbers) {
    Distribution distribution{.name = number.name, .unit = number.unit};
    if (recipe && number.limits) distribution.limits = number.limits(*recipe);
    if (!distribution.limits) distribution.limits = drawn_limits(dataset, number.name);
    if (distribution.limits) distribution.note = number.note;
    std::vector<double> of_group;
    for (const DatasetGroup& group : dataset.groups)
      of_group.push_back(number.needs_lens && is_undistorted(group.label) ? NAN : number.of(group.label));
    for (const DatasetImage& image : dataset.images)
      if (!std::isnan(of_group[image.group])) distribution.add(image.part, of_group[image.group]);
    distributions.push_back(std::move(distribution));
  }
  return distributions;
}

}  // namespace cps
