#include <algorithm>
#include <catch2/catch.hpp>

#include "dataset/report/survey.h"
#include "numbers/angles.h"
#include "tests/dataset/edit_csv.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

namespace {

const Distribution& named(const std::vector<Distribution>& distributions, const std::string& name) {
  const auto found = std::ranges::find(distributions, name, &Distribution::name);
  REQUIRE(found != distributions.end());
  return *found;
}

std::vector<double> sorted(std::vector<double> values) {
  std::ranges::sort(values);
  return values;
}

}  // namespace

TEST_CASE("a survey adds up what the plan made") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  write_small_dataset(temporary.path, plan);
  const DatasetSurvey survey = survey_dataset(temporary.path);
  REQUIRE(survey.frames);
  CHECK(survey.description->name == "small");
  CHECK(survey.description->scenes.size() == 1);
  CHECK(survey.description->places->drawn == plan.places.drawn);

  // Numbers of lenses, by part and once per image.
  std::array<std::vector<double>, 3> k1, hfov_deg, heading_deg;
  std::array<std::set<std::string>, 3> streets;
  std::vector<std::int64_t> images_of_condition(plan.conditions.size());
  std::set<MapPlace> places;
  double most_error_deg = 0;
  for (const PlannedView& view : plan.views) {
    const auto p = static_cast<std::size_t>(view.part);
    streets[p].insert(view.street);
    places.insert({view.part, view.place.position.x(), view.place.position.z(), 0});
    for (int g : view.groups) {
      const DrawnLens& lens = plan.groups[g].lens;
      if (plan.groups[g].lens_number > 0) k1[p].push_back(lens.distortion.k1);
      hfov_deg[p].push_back(degrees(hfov_rad(lens.crop.camera)));
      heading_deg[p].push_back(std::remainder(degrees(view.place.heading_rad), 360.0));
      ++images_of_condition[view.condition];
    }
    const Eigen::Isometry3d error =
        vehicle_from_camera(plan.rig.cameras[view.rig_camera]).inverse() * vehicle_from_camera(view.camera);
    const Eigen::AngleAxisd turn(error.linear());
    most_error_deg = std::max(most_error_deg, degrees(turn.angle() * turn.axis().y()));
  }
  for (std::size_t p = 0; p < 3; ++p) {
    CHECK(sorted(named(survey.labels, "k1").values[p]) == sorted(k1[p]));
    CHECK(sorted(named(survey.labels, "H-FOV").values[p]).size() == hfov_deg[p].size());
    for (std::size_t i = 0; i < hfov_deg[p].size(); ++i)
      CHECK(sorted(named(survey.labels, "H-FOV").values[p])[i] == Approx(sorted(hfov_deg[p])[i]));
    const std::vector<double> headings =
        sorted(named(survey.frames->distributions, "vehicle heading").values[p]);
    REQUIRE(headings.size() == heading_deg[p].size());
    for (std::size_t i = 0; i < headings.size(); ++i)
      CHECK(headings[i] == Approx(sorted(heading_deg[p])[i]).margin(1e-9));
    CHECK(survey.frames->streets[p].size() == streets[p].size());
  }
  CHECK(survey.frames->images_of_condition == images_of_condition);
  REQUIRE(survey.frames->places.size() == 1);
  CHECK(survey.frames->places.begin()->second.size() == places.size());

  const DistributionSummary error =
      summary_of(named(survey.frames->distributions, "mount error about the camera's y axis"));
  CHECK(error.count == image_count(plan));
  CHECK(error.max == Approx(most_error_deg).margin(1e-6));
  // Nothing the plan draws lies outside its limits.
  for (const auto* distributions : {&survey.labels, &survey.frames->distributions})
    for (const Distribution& distribution : *distributions) {
      INFO(distribution.name);
      CHECK(summary_of(distribution).outside == 0);
    }
  const Distribution& drawn = named(survey.labels, "k1");
  REQUIRE(drawn.limits);
  for (const PlannedGroup& group : plan.groups)
    if (const auto& own = group.lens.limits[0]) {
      CHECK(own->low >= drawn.limits->low);
      CHECK(own->high <= drawn.limits->high);
    }
}

TEST_CASE("a survey names the file that is missing or wrong") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_small_dataset(root, plan);
  const auto csv = root / plan.groups[1].folder / "frames.csv";
  const std::string frames = read_file(csv);
  edit_column(csv, "condition", [](const std::string&) { return "7"; });
  CHECK_THROWS_WITH(survey_dataset(root), Catch::Contains("condition 7 is not in dataset.json"));
  write_file(csv, frames);

  nlohmann::ordered_json description = nlohmann::ordered_json::parse(read_file(root / "dataset.json"));
  description["conditions"][0]["turbidity"] = "thick";
  write_json(root / "dataset.json", description);
  CHECK_THROWS_WITH(survey_dataset(root), Catch::EndsWith("dataset.json: turbidity: must be a number"));
  description["conditions"] = 3;
  write_json(root / "dataset.json", description);
  CHECK_THROWS_WITH(survey_dataset(root), Catch::EndsWith("dataset.json: conditions: must be a list"));
}
