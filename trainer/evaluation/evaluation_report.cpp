#include <fmt/format.h>

#include <cmath>

#include "trainer/evaluation/evaluate.h"

namespace cps {
namespace {

using Columns = std::array<const LensErrors*, 3>;

std::string row(const std::string& name, const char* unit, const std::array<double, 3>& values) {
  return fmt::format("{:<24} {:<5} {:12.4g} {:12.4g} {:12.4g}\n", name, unit, values[0], values[1],
                     values[2]);
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
  return fmt::format("{:<34} {:9.4g} {:<4} [{:.4g}, {:.4g}]\n", name, e.value, unit, e.interval.low,
                     e.interval.high);
}

std::string headline_rows(const Headline& h) {
  return "\n95 % intervals by bootstrap over places:\n" +
         estimate_row("H-FOV error, mean", "deg", h.hfov_mean_deg) +
         estimate_row("H-FOV error, median", "deg", h.hfov_median_deg) +
         estimate_row("H-FOV, correlation", "", h.hfov_correlation) +
         estimate_row("reprojection, mean", "px", h.reprojection_mean_px) +
         estimate_row("reprojection, median", "px", h.reprojection_median_px) +
         estimate_row("H-FOV error by train mean's", "", h.hfov_ratio) +
         estimate_row("reprojection by train mean's", "", h.reprojection_ratio) +
         estimate_row("k1 apparent, R squared", "", h.k1_r2);
}

std::string bin_rows(const std::vector<EvaluationBin>& bins) {
  std::string text = fmt::format("\n{:<7} {:<16} {:>7} {:>16} {:>16} {:>16} {:>16}\n", "", "", "images",
                                 "H-FOV error deg", "train mean's", "reprojection px", "train mean's");
  for (const EvaluationBin& bin : bins)
    text += fmt::format("{:<7} {:<16} {:7} {:16.4g} {:16.4g} {:16.4g} {:16.4g}\n", bin.kind, bin.name,
                        bin.images, bin.network.hfov_mean_deg, bin.training_mean.hfov_mean_deg,
                        bin.network.reprojection_mean_px, bin.training_mean.reprojection_mean_px);
  return text;
}

std::string robustness_rows(const std::vector<RobustnessRow>& rows) {
  if (rows.empty()) return "";
  std::string text = fmt::format("\n{:<24} {:>10} {:>16} {:>16}\n", "images corrupted by", "loss",
                                 "H-FOV error deg", "reprojection px");
  for (const RobustnessRow& r : rows)
    text += fmt::format("{:<24} {:10.4g} {:16.4g} {:16.4g}\n", r.name, r.loss, r.hfov_mean_deg,
                        r.reprojection_mean_px);
  return text;
}

std::string coverage_rows(const std::optional<Coverage>& coverage) {
  if (!coverage) return "";
  std::string text = fmt::format("\n{:<24} {:>12} {:>12} {:>24}\n", "errors within deviations", "one", "two",
                                 "rms error / deviation");
  for (int i = 0; i < output_count; ++i)
    text +=
        fmt::format("{:<24} {:10.1f} % {:10.1f} % {:24.3g}\n", output_names[i], 100 * coverage->within_one[i],
                    100 * coverage->within_two[i], coverage->scaled_error[i]);
  return text;
}

std::string auc_rows(const Columns& columns) {
  std::string text;
  for (std::size_t t = 0; t < LensErrors::auc_thresholds_deg.size(); ++t) {
    text += row(fmt::format("H-FOV AUC@{:g}", LensErrors::auc_thresholds_deg[t]), "",
                {columns[0]->hfov_auc[t], columns[1]->hfov_auc[t], columns[2]->hfov_auc[t]});
  }
  return text;
}

}  // namespace

std::string Evaluation::report() const {
  const Columns columns{&network, &training_mean, &centre};
  std::string text = fmt::format("{} {}, model {}\n", network.images, set, model);
  for (const std::string& why : skipped) text += "left out: " + why + "\n";
  text += fmt::format("{:<30} {:>12} {:>12} {:>12}\n", "", "network", "train mean", "centre");
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
  text += cps::report(rays) + bin_rows(bins) + cps::report(cameras) + coverage_rows(coverage) +
          robustness_rows(robustness) + headline_rows(headline);
  return text +
         fmt::format("H-FOV error {:.0f} % {} the training mean's; reprojection error {:.0f} % {}\n",
                     100 * std::abs(1 - network.hfov_mean_deg / training_mean.hfov_mean_deg),
                     network.hfov_mean_deg < training_mean.hfov_mean_deg ? "below" : "above",
                     100 * std::abs(1 - network.reprojection_mean_px / training_mean.reprojection_mean_px),
                     network.reprojection_mean_px < training_mean.reprojection_mean_px ? "below" : "above");
}

}  // namespace cps
