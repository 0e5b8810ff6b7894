#include <cstdio>

#include "trainer/evaluate.h"

namespace cps {
namespace {

using Columns = std::array<const LensErrors*, 3>;

std::string row(const std::string& name, const char* unit, const std::array<double, 3>& values) {
  char line[160];
  std::snprintf(line, sizeof line, "%-24s %-5s %12.4g %12.4g %12.4g\n", name.c_str(), unit, values[0],
                values[1], values[2]);
  return line;
}

std::string row(const std::string& name, const char* unit, const Columns& columns,
                double LensErrors::*value) {
  return row(name, unit, {columns[0]->*value, columns[1]->*value, columns[2]->*value});
}

std::string count_row(const std::string& name, const Columns& columns, int LensErrors::*value) {
  return row(name, "", {double(columns[0]->*value), double(columns[1]->*value), double(columns[2]->*value)});
}

std::string output_rows(const std::string& measure, const Columns& columns, Outputs LensErrors::*values,
                        int first, int last, const char* suffix) {
  std::string text;
  for (int i = first; i < last; ++i)
    text += row(measure + " " + output_names[i] + suffix, i == 0 ? "rad" : "",
                {(columns[0]->*values)[i], (columns[1]->*values)[i], (columns[2]->*values)[i]});
  return text;
}

nlohmann::ordered_json to_json(const LensErrors& e) {
  const auto named = [](const Outputs& values) {
    nlohmann::ordered_json json;
    for (int i = 0; i < output_count; ++i) json[output_names[i]] = values[i];
    return json;
  };
  return {{"images", e.images},
          {"hfov_deg", {{"mean", e.hfov_mean_deg}, {"median", e.hfov_median_deg}}},
          {"reprojection_px",
           {{"mean", e.reprojection_mean_px},
            {"median", e.reprojection_median_px},
            {"p95", e.reprojection_p95_px}}},
          {"without_camera", e.without_camera},
          {"folding", e.folding},
          {"raw", {{"mae", named(e.raw_mae)}, {"rmse", named(e.raw_rmse)}}},
          {"apparent", {{"mae", named(e.apparent_mae)}, {"rmse", named(e.apparent_rmse)}}}};
}

}  // namespace

std::string Evaluation::report() const {
  const Columns columns{&network, &training_mean, &centre};
  char line[160];
  std::string text = std::to_string(network.images) + " " + to_string(part) + " images of " + dataset +
                     ", model " + model + "\n";
  std::snprintf(line, sizeof line, "%-30s %12s %12s %12s\n", "", "network", "train mean", "centre");
  text += line;
  text += row("H-FOV error, mean", "deg", columns, &LensErrors::hfov_mean_deg);
  text += row("H-FOV error, median", "deg", columns, &LensErrors::hfov_median_deg);
  text += row("reprojection, mean", "px", columns, &LensErrors::reprojection_mean_px);
  text += row("reprojection, median", "px", columns, &LensErrors::reprojection_median_px);
  text += row("reprojection, 95 %", "px", columns, &LensErrors::reprojection_p95_px);
  text += count_row("lenses that fold", columns, &LensErrors::folding);
  text += count_row("no camera", columns, &LensErrors::without_camera);
  text += output_rows("MAE", columns, &LensErrors::raw_mae, 0, output_count, "");
  text += output_rows("RMSE", columns, &LensErrors::raw_rmse, 0, output_count, "");
  text += output_rows("MAE", columns, &LensErrors::apparent_mae, 1, 6, " apparent");
  std::snprintf(line, sizeof line,
                "H-FOV error %.0f %% %s the training mean's; reprojection error %.0f %% %s\n",
                100 * std::abs(1 - network.hfov_mean_deg / training_mean.hfov_mean_deg),
                network.hfov_mean_deg < training_mean.hfov_mean_deg ? "below" : "above",
                100 * std::abs(1 - network.reprojection_mean_px / training_mean.reprojection_mean_px),
                network.reprojection_mean_px < training_mean.reprojection_mean_px ? "below" : "above");
  return text + line;
}

nlohmann::ordered_json to_json(const Evaluation& evaluation) {
  return {{"model", evaluation.model},
          {"dataset", evaluation.dataset},
          {"part", to_string(evaluation.part)},
          {"network", to_json(evaluation.network)},
          {"training_mean", to_json(evaluation.training_mean)},
          {"centre", to_json(evaluation.centre)}};
}

}  // namespace cps
