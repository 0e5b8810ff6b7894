#include "trainer/training/history.h"

#include <fmt/format.h>

#include <array>

#include "files/files.h"
#include "files/plot.h"

namespace cps {
namespace {

/// A column of history.csv.
struct Column {
  const char* name;
  double EpochReport::*value;
  int digits;  ///< significant
};

constexpr std::array columns{Column{"learning_rate", &EpochReport::learning_rate, 6},
                             Column{"training_loss", &EpochReport::training_loss, 6},
                             Column{"validation_loss", &EpochReport::validation_loss, 6},
                             Column{"validation_cosine", &EpochReport::validation_cosine, 6},
                             Column{"validation_hfov_mae_deg", &EpochReport::validation_hfov_mae_deg, 6},
                             Column{"images_per_second", &EpochReport::images_per_second, 4},
                             Column{"loader_share", &EpochReport::loader_share, 3}};

std::string csv_of(const std::vector<EpochReport>& epochs) {
  std::string csv = "epoch";
  for (const Column& column : columns) csv += fmt::format(",{}", column.name);
  csv += "\n";
  for (const EpochReport& report : epochs) {
    csv += fmt::format("{}", report.epoch);
    for (const Column& column : columns) csv += fmt::format(",{:.{}g}", report.*column.value, column.digits);
    csv += "\n";
  }
  return csv;
}

PlotSeries curve(const char* name, const std::vector<EpochReport>& epochs, double EpochReport::*value) {
  PlotSeries series{.name = name};
  for (const EpochReport& r : epochs) series.points.emplace_back(r.epoch, r.*value);
  return series;
}

std::string curves_of(const std::vector<EpochReport>& epochs) {
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
  write_file(model_folder / "history.csv", csv_of(epochs));
  write_file(model_folder / "history.svg", curves_of(epochs));
}

}  // namespace cps
