#include <cmath>

#include "trainer/evaluation/evaluate.h"

namespace cps {
namespace {

using Json = nlohmann::ordered_json;

Json named(const Outputs& values) {
  Json json;
  for (int i = 0; i < output_count; ++i) json[output_names[i]] = values[i];
  return json;
}

Json to_json(const LensErrors& e) {
  Json auc;
  for (std::size_t t = 0; t < e.hfov_auc.size(); ++t)
    auc[std::to_string(static_cast<int>(LensErrors::auc_thresholds_deg[t]))] = e.hfov_auc[t];
  return {{"images", e.images},
          {"hfov_deg",
           {{"mean", e.hfov_mean_deg},
            {"median", e.hfov_median_deg},
            {"auc", auc},
            {"correlation", e.hfov_correlation}}},
          {"e_f_median", e.focal_median},
          {"e_b_mean", e.principal_point_mean},
          {"k1_mean", e.k1_mean},
          {"reprojection_px",
           {{"mean", e.reprojection_mean_px},
            {"median", e.reprojection_median_px},
            {"p95", e.reprojection_p95_px}}},
          {"angle_deg", {{"mean", e.angle_mean_deg}, {"median", e.angle_median_deg}}},
          {"without_camera", e.without_camera},
          {"folding", e.folding},
          {"raw", {{"mae", named(e.raw_mae)}, {"mse", named(e.raw_mse)}, {"rmse", named(e.raw_rmse)}}},
          {"apparent", {{"mae", named(e.apparent_mae)}, {"rmse", named(e.apparent_rmse)}}}};
}

Json to_json(const Estimate& e) {
  return {{"value", e.value}, {"low", e.interval.low}, {"high", e.interval.high}};
}

Json to_json(const Headline& h) {
  return {{"hfov_mean_deg", to_json(h.hfov_mean_deg)},
          {"hfov_median_deg", to_json(h.hfov_median_deg)},
          {"hfov_correlation", to_json(h.hfov_correlation)},
          {"reprojection_mean_px", to_json(h.reprojection_mean_px)},
          {"reprojection_median_px", to_json(h.reprojection_median_px)},
          {"hfov_ratio", to_json(h.hfov_ratio)},
          {"reprojection_ratio", to_json(h.reprojection_ratio)},
          {"k1_r2", to_json(h.k1_r2)}};
}

Json to_json(const EvaluationBin& bin) {
  return {{"kind", bin.kind},
          {"name", bin.name},
          {"images", bin.images},
          {"network", to_json(bin.network)},
          {"training_mean", to_json(bin.training_mean)},
          {"intervals_95",
           {{"hfov_mean_deg", to_json(Estimate{bin.network.hfov_mean_deg, bin.hfov_interval_deg})},
            {"reprojection_mean_px",
             to_json(Estimate{bin.network.reprojection_mean_px, bin.reprojection_interval_px})}}}};
}

/// The points of the reliability curve in columns: the number of deviations, a normal distribution's share
/// within them, and that of the errors of each output.
Json reliability_json(const Coverage& coverage) {
  Json json{{"deviations", Json::array()}, {"normal", Json::array()}};
  for (int point = 0; point < reliability_points; ++point) {
    json["deviations"].push_back(reliability_deviations(point));
    json["normal"].push_back(normal_share(reliability_deviations(point)));
    for (int i = 0; i < output_count; ++i) json[output_names[i]].push_back(coverage.within[point][i]);
  }
  return json;
}

Json to_json(const EvaluatedImage& image) {
  const Pinhole& camera = image.image.truth.pinhole;
  Json json{{"file", image.image.name},
            {"camera", image.image.camera},
            {"width", camera.width},
            {"height", camera.height},
            {"true", named(to_outputs(image.image.truth, TargetSpace::raw))},
            {"said", named(image.predicted)},
            {"hfov_error_deg", image.network.hfov_deg},
            {"folds", image.network.folds}};
  if (image.deviation) json["deviation"] = named(*image.deviation);
  json["reprojection_px"] =
      image.network.reprojection_px ? Json(*image.network.reprojection_px) : Json(nullptr);
  return json;
}

}  // namespace

Json to_json(const Evaluation& evaluation) {
  Json json{{"model", evaluation.model},
            {"set", evaluation.set},
            {"skipped", evaluation.skipped},
            {"intervals_95", to_json(evaluation.headline)},
            {"network", to_json(evaluation.network)},
            {"training_mean", to_json(evaluation.training_mean)},
            {"centre", to_json(evaluation.centre)}};
  json["bins"] = Json::array();
  for (const EvaluationBin& bin : evaluation.bins) json["bins"].push_back(to_json(bin));
  json["robustness"] = Json::array();
  for (const RobustnessRow& row : evaluation.robustness)
    json["robustness"].push_back({{"name", row.name},
                                  {"loss", row.loss},
                                  {"hfov_mean_deg", row.hfov_mean_deg},
                                  {"reprojection_mean_px", row.reprojection_mean_px}});
  json["rays"] = to_json(evaluation.rays);
  if (const auto& coverage = evaluation.coverage) {
    json["coverage"] = {{"within_one", named(coverage->within_one)},
                        {"within_two", named(coverage->within_two)},
                        {"scaled_error", named(coverage->scaled_error)}};
    json["reliability"] = reliability_json(*coverage);
  }
  if (!evaluation.cameras.empty()) json["cameras"] = to_json(evaluation.cameras);
  json["images"] = Json::array();
  for (const EvaluatedImage& image : evaluation.images) json["images"].push_back(to_json(image));
  return json;
}

}  // namespace cps
