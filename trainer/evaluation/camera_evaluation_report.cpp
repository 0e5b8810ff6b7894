#include <fmt/format.h>

#include <algorithm>

#include "trainer/evaluation/camera_evaluation.h"
#include "trainer/evaluation/camera_numbers.h"

/// Table and JSON of CameraEvaluations.
namespace cps {
namespace {

/// What fits on a screen. JSON has all.
constexpr std::size_t most_lines = 24;

const char* in_words(const CameraError& error) {
  return error.is_within(1) ? "one" : error.is_within(2) ? "two" : "more";
}

std::string camera_row(const CameraEvaluation& c) {
  return fmt::format("{:<28} {:>4}/{:<4} {:9.3g} {:9.3g} {:>5} {:10.3g} {:9.3g} {:>5} {:10.3g} {:9.3g}\n",
                     c.name, c.trusted_frames, c.frames, c.hfov_deg.joint, c.hfov_deg.single_mean,
                     in_words(c.hfov_deg), c.k1.joint, c.k1.single_mean, in_words(c.k1),
                     c.reprojection_px.joint, c.reprojection_px.single_mean);
}

double mean_over(std::span<const CameraEvaluation> cameras, CameraError CameraEvaluation::*error,
                 double CameraError::*value) {
  double sum = 0;
  for (const CameraEvaluation& camera : cameras) sum += camera.*error.*value;
  return sum / static_cast<double>(cameras.size());
}

double share_within(std::span<const CameraEvaluation> cameras, CameraError CameraEvaluation::*error,
                    double deviations) {
  const auto count = std::ranges::count_if(
      cameras, [&](const CameraEvaluation& camera) { return (camera.*error).is_within(deviations); });
  return static_cast<double>(count) / static_cast<double>(cameras.size());
}

std::string mean_rows(std::span<const CameraEvaluation> cameras) {
  const auto mean = [&](CameraError CameraEvaluation::*error, double CameraError::*value) {
    return mean_over(cameras, error, value);
  };
  std::string text = fmt::format("{:<28} {:9} {:9.3g} {:9.3g} {:5} {:10.3g} {:9.3g} {:5} {:10.3g} {:9.3g}\n",
                                 fmt::format("mean of {} cameras", cameras.size()), "",
                                 mean(&CameraEvaluation::hfov_deg, &CameraError::joint),
                                 mean(&CameraEvaluation::hfov_deg, &CameraError::single_mean), "",
                                 mean(&CameraEvaluation::k1, &CameraError::joint),
                                 mean(&CameraEvaluation::k1, &CameraError::single_mean), "",
                                 mean(&CameraEvaluation::reprojection_px, &CameraError::joint),
                                 mean(&CameraEvaluation::reprojection_px, &CameraError::single_mean));
  text += fmt::format(
      "truth within one and two deviations: H-FOV {:.0f} % and {:.0f} %, K1 {:.0f} % and {:.0f} %\n",
      100 * share_within(cameras, &CameraEvaluation::hfov_deg, 1),
      100 * share_within(cameras, &CameraEvaluation::hfov_deg, 2),
      100 * share_within(cameras, &CameraEvaluation::k1, 1),
      100 * share_within(cameras, &CameraEvaluation::k1, 2));
  return text;
}

nlohmann::ordered_json error_json(const CameraError& error) {
  nlohmann::ordered_json json{{"joint", error.joint}, {"single_mean", error.single_mean}};
  if (!(error.deviation > 0)) return json;
  json["deviation"] = error.deviation;
  json["within_one"] = error.is_within(1);
  json["within_two"] = error.is_within(2);
  return json;
}

}  // namespace

std::string report(std::span<const CameraEvaluation> cameras) {
  if (cameras.empty()) return "";
  std::string text = fmt::format(
      "\n{:<28} {:>9} {:>9} {:>9} {:>5} {:>10} {:>9} {:>5} {:>10} {:>9}\n{:<28} {:>9} {:>9} {:>9} {:>5} "
      "{:>10} {:>9} {:>5} {:>10} {:>9}\n",
      "one camera from all its", "pictures", "H-FOV deg", "single", "devi-", "K1", "single", "devi-",
      "reproj. px", "single", "pictures, errors", "trusted", "joint", "mean", "ation", "joint", "mean",
      "ation", "joint", "mean");
  for (const CameraEvaluation& camera : cameras.first(std::min(most_lines, cameras.size())))
    text += camera_row(camera);
  if (cameras.size() > most_lines) text += "… (the JSON file has all)\n";
  return text + mean_rows(cameras);
}

nlohmann::ordered_json to_json(std::span<const CameraEvaluation> cameras) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CameraEvaluation& c : cameras) {
    const auto fitted =
        to_camera(c.predicted, TargetSpace::raw, c.truth.pinhole.width, c.truth.pinhole.height);
    list.push_back({{"name", c.name},
                    {"frames", c.frames},
                    {"trusted", c.trusted_frames},
                    {"true", numbers_json(c.truth)},
                    {"said", fitted ? numbers_json(*fitted) : nlohmann::ordered_json(nullptr)},
                    {"hfov_error_deg", error_json(c.hfov_deg)},
                    {"k1_error", error_json(c.k1)},
                    {"reprojection_px", error_json(c.reprojection_px)}});
  }
  return list;
}

}  // namespace cps
