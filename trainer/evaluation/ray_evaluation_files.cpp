#include <fmt/format.h>

#include <utility>
#include <vector>

#include "dataset/exchange/camera_json.h"
#include "files/html_page.h"
#include "files/markup.h"
#include "files/plot.h"
#include "numbers/angles.h"
#include "trainer/evaluation/evaluate_rays.h"

/// eval.json and eval.html of a RayEvaluation.
namespace cps {
namespace {

nlohmann::ordered_json image_json(const RayEvaluatedImage& image) {
  using Json = nlohmann::ordered_json;
  const ModelCamera& truth = image.image.truth->camera;
  Json json{{"file", image.image.name},
            {"camera", image.image.camera},
            {"true", model_camera_json(truth.pinhole, truth.lens)}};
  json["said"] =
      image.predicted ? model_camera_json(image.predicted->pinhole, image.predicted->lens) : Json(nullptr);
  const RayErrors& errors = image.network;
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  json["angle_mean_deg"] = errors.angles ? Json(errors.angles->mean_deg) : Json(nullptr);
  json["angle_p95_deg"] = errors.angles ? Json(errors.angles->p95_deg) : Json(nullptr);
  json["turned_mean_deg"] = errors.angles ? Json(errors.angles->turned_mean_deg) : Json(nullptr);
  json["reprojection_px"] = number(errors.reprojection_px);
  json["seen_hfov_error_deg"] = number(errors.seen_hfov_deg);
  return json;
}

/// The mean angle of each image's rays against what the image sees.
Plot angle_plot(const RayEvaluation& evaluation) {
  Plot plot{.title = "angle of rays", .x_label = "H-FOV that is seen, degrees", .y_label = "mean, degrees"};
  PlotSeries network{.name = "network", .style = PlotStyle::dots},
      mean{.name = "train mean", .style = PlotStyle::dots};
  for (const RayEvaluatedImage& image : evaluation.images) {
    const std::optional<double> seen = image.image.truth->seen_hfov_rad;
    if (!seen) continue;
    if (image.network.angles) network.points.emplace_back(degrees(*seen), image.network.angles->mean_deg);
    if (image.training_mean.angles)
      mean.points.emplace_back(degrees(*seen), image.training_mean.angles->mean_deg);
  }
  plot.series = {std::move(network), std::move(mean)};
  return plot;
}

}  // namespace

nlohmann::ordered_json to_json(const RayEvaluation& evaluation) {
  nlohmann::ordered_json json{{"model", evaluation.model},
                              {"set", evaluation.set},
                              {"skipped", evaluation.skipped},
                              {"rays", to_json(evaluation.comparison)}};
  json["images"] = nlohmann::ordered_json::array();
  for (const RayEvaluatedImage& image : evaluation.images) json["images"].push_back(image_json(image));
  return json;
}

std::string to_html(const RayEvaluation& evaluation) {
  return html_page("cps eval: " + evaluation.set,
                   fmt::format("<h1>{}</h1>\n<pre>{}</pre>\n{}", escaped(evaluation.set),
                               escaped(evaluation.report()), to_svg(std::vector{angle_plot(evaluation)}, 1)));
}

}  // namespace cps
