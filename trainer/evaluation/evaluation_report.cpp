#include <cmath>
#include <cstdio>

#include "trainer/evaluation/evaluate.h"

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

std::string estimate_row(const char* name, const char* unit, const Estimate& e) {
  char line[160];
  std::snprintf(line, sizeof line, "%-34s %9.4g %-4s [%.4g, %.4g]\n", name, e.value, unit, e.interval.low,
                e.interval.high);
  return line;
}

std::string headline_rows(const Headline& h) {
  return "\n95 % intervals by bootstrap over places:\n" +
         estimate_row("H-FOV error, mean", "deg", h.hfov_mean_deg) +
         estimate_row("H-FOV error, median", "deg", h.hfov_median_deg) +
         estimate_row("H-FOV, correlation", "", h.hfov_correlation) +
         estimate_row("reprojection, mean", "px", h.reprojection_mean_px) +
         estimate_row("reprojection, median", "px", h.reprojection_median_px) +
         estimate_row("H-FOV error by train mean's", "", h.hfov_ratio) +
         estimate_row("reprojection by train mean's", "", h.reprojection_ratio);
}

std::string bin_rows(const std::vector<EvaluationBin>& bins) {
  char line[200];
  std::snprintf(line, sizeof line, "\n%-7s %-16s %7s %16s %16s %16s %16s\n", "", "", "images",
                "H-FOV error deg", "train mean's", "reprojection px", "train mean's");
  std::string text = line;
  for (const EvaluationBin& bin : bins) {
    std::snprintf(line, sizeof line, "%-7s %-16s %7d %16.4g %16.4g %16.4g %16.4g\n", bin.kind.c_str(),
                  bin.name.c_str(), bin.images, bin.network.hfov_mean_deg, bin.training_mean.hfov_mean_deg,
                  bin.network.reprojection_mean_px, bin.training_mean.reprojection_mean_px);
    text += line;
  }
  return text;
}

std::string robustness_rows(const std::vector<RobustnessRow>& rows) {
  if (rows.empty()) return "";
  char line[160];
  std::snprintf(line, sizeof line, "\n%-24s %10s %16s %16s\n", "images spoilt by", "loss", "H-FOV error deg",
                "reprojection px");
  std::string text = line;
  for (const RobustnessRow& r : rows) {
    std::snprintf(line, sizeof line, "%-24s %10.4g %16.4g %16.4g\n", r.name.c_str(), r.loss, r.hfov_mean_deg,
                  r.reprojection_mean_px);
    text += line;
  }
  return text;
}

std::string auc_rows(const Columns& columns) {
  std::string text;
  for (std::size_t t = 0; t < LensErrors::auc_thresholds_deg.size(); ++t) {
    char name[32];
    std::snprintf(name, sizeof name, "H-FOV AUC@%g", LensErrors::auc_thresholds_deg[t]);
    text += row(name, "", {columns[0]->hfov_auc[t], columns[1]->hfov_auc[t], columns[2]->hfov_auc[t]});
  }
  return text;
}

}  // namespace

std::string Evaluation::report() const {
  const Columns columns{&network, &training_mean, &centre};
  char line[160];
  std::string text = std::to_string(network.images) + " " + set + ", model " + model + "\n";
  for (const std::string& why : skipped) text += "left out: " + why + "\n";
  std::snprintf(line, sizeof line, "%-30s %12s %12s %12s\n", "", "network", "train mean", "centre");
  text += line;
  text += row("H-FOV error, mean", "deg", columns, &LensErrors::hfov_mean_deg);
  text += row("H-FOV error, median", "deg", columns, &LensErrors::hfov_median_deg);
  text += auc_rows(columns);
  text += row("e_f, median", "", columns, &LensErrors::focal_median);
  text += row("e_b, mean", "", columns, &LensErrors::principal_point_mean);
  text += row("|dk1|, mean", "", columns, &LensErrors::k1_mean);
  text += row("reprojection, mean", "px", columns, &LensErrors::reprojection_mean_px);
  text += row("reprojection, median", "px", columns, &LensErrors::reprojection_median_px);
  text += row("reprojection, 95 %", "px", columns, &LensErrors::reprojection_p95_px);
  text += row("angle of rays, mean", "deg", columns, &LensErrors::angle_mean_deg);
  text += row("angle of rays, median", "deg", columns, &LensErrors::angle_median_deg);
  text += count_row("lenses that fold", columns, &LensErrors::folding);
  text += count_row("no camera", columns, &LensErrors::without_camera);
  text += output_rows("MAE", columns, &LensErrors::raw_mae, 0, output_count, "");
  text += output_rows("MSE", columns, &LensErrors::raw_mse, 0, output_count, "");
  text += output_rows("RMSE", columns, &LensErrors::raw_rmse, 0, output_count, "");
  text += output_rows("MAE", columns, &LensErrors::apparent_mae, 1, 6, " apparent");
  text += bin_rows(bins) + robustness_rows(robustness) + headline_rows(headline);
  std::snprintf(line, sizeof line,
                "H-FOV error %.0f %% %s the training mean's; reprojection error %.0f %% %s\n",
                100 * std::abs(1 - network.hfov_mean_deg / training_mean.hfov_mean_deg),
                network.hfov_mean_deg < training_mean.hfov_mean_deg ? "below" : "above",
                100 * std::abs(1 - network.reprojection_mean_px / training_mean.reprojection_mean_px),
                network.reprojection_mean_px < training_mean.reprojection_mean_px ? "below" : "above");
  return text + line;
}

}  // namespace cps
