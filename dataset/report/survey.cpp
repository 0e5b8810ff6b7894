#include "dataset/report/survey.h"

#include <fmt/format.h>

#include <stdexcept>

#include "dataset/job/frames.h"
#include "dataset/job/recipe_json.h"
#include "dataset/report/frame_distributions.h"
#include "dataset/report/label_distributions.h"

namespace cps {
namespace {

void add_rows(FrameSurvey& survey, const std::filesystem::path& file, const Label& label,
              const std::vector<Description::Condition>& conditions) {
  for (const FrameRow& row : read_frames_csv(file)) {
    if (row.condition >= static_cast<std::int64_t>(conditions.size()))
      throw std::runtime_error(
          fmt::format("{}: {}: condition {} is not in dataset.json", file.string(), row.file, row.condition));
    const std::string& map = conditions[row.condition].streets;
    ++survey.images_of_condition[row.condition];
    const Place& car = row.vehicle;
    survey.places[map].insert({row.part, car.position.x(), car.position.z(), car.heading_rad});
    survey.streets[static_cast<std::size_t>(row.part)].insert(map + "\n" + row.street);
    add_frame(survey.distributions, row, label);
  }
}

FrameSurvey survey_frames(const Dataset& dataset, const Description& description, const Recipe& recipe) {
  FrameSurvey survey{.images_of_condition = std::vector<std::int64_t>(description.conditions.size()),
                     .places = {},
                     .streets = {},
                     .distributions = frame_distributions(recipe)};
  for (const DatasetGroup& group : dataset.groups)
    add_rows(survey, dataset.root / group.folder / "frames.csv", group.label, description.conditions);
  return survey;
}

}  // namespace

DatasetSurvey survey_dataset(const std::filesystem::path& root) {
  DatasetSurvey survey{.files = open_dataset(root)};
  const Dataset& dataset = survey.files.dataset;
  if (survey.files.description) {
    survey.description = description_from_json(*survey.files.description, (root / "dataset.json").string());
    survey.recipe = read_recipe(root);
    survey.frames = survey_frames(dataset, *survey.description, *survey.recipe);
  }
  survey.images_of_group.resize(dataset.groups.size());
  for (const DatasetImage& image : dataset.images) ++survey.images_of_group[image.group];
  survey.labels = label_distributions(dataset, survey.recipe);
  return survey;
}

}  // namespace cps
