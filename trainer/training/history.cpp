#include "trainer/training/history.h"

#include <cstdio>

#include "files/files.h"
#include "files/plot.h"

namespace cps {
namespace {

PlotSeries curve(const char* name, const std::vector<EpochReport>& epochs, double EpochReport::*value) {
  PlotSeries series{.name = name};
  for (const EpochReport& r : epochs) series.points.emplace_back(r.epoch, r.*value);
  return series;
}

std::string picture(const std::vector<EpochReport>& epochs) {
  const std::vector<Plot> plots{
      {.title = "loss",
       .x_label = "epoch",
       .y_label = "loss",
       .series = {curve("training", epochs, &EpochReport::training_loss),
                  curve("validation", epochs, &EpochReport::validation_loss)}},
      {.title = "cosine similarity, validation",
       .x_label = "epoch",
       .y_label = "cosine",
       .series = {curve("", epochs, &EpochReport::validation_cosine)}},
      {.title = "H-FOV error, validation",
       .x_label = "epoch",
       .y_label = "mean, degrees",
       .series = {curve("", epochs, &EpochReport::validation_hfov_mae_deg)}},
  };
  return to_svg(plots, 3);
}

}  // namespace

void save_history(const std::vector<EpochReport>& epochs, const std::filesystem::path& model_folder) {
  std::string csv =
      "epoch,learning_rate,training_loss,validation_loss,validation_cosine,validation_hfov_mae_deg,images_"
      "per_second,loader_share\n";
  char line[256];
  for (const EpochReport& r : epochs) {
    std::snprintf(line, sizeof line, "%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.4g,%.3g\n", r.epoch, r.learning_rate,
                  r.training_loss, r.validation_loss, r.validation_cosine, r.validation_hfov_mae_deg,
                  r.images_per_second, r.loader_share);
    csv += line;
  }
  write_file(model_folder / "history.csv", csv);
  write_file(model_folder / "history.svg", picture(epochs));
}

}  // namespace cps
