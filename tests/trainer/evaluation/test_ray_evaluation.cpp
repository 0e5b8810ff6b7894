#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/deepcalib/sphere_street.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/evaluate_rays.h"
#include "trainer/evaluation/predict_spheres.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

TrainOptions one_epoch(Head head) {
  TrainOptions options;
  options.head = head;
  options.architecture = "resnet18-16";
  options.reduction.width = 48;
  options.epochs = 1;
  options.batch_size = 4;
  return options;
}

}  // namespace

TEST_CASE("networks of both families are measured on pictures of both") {
  const TemporaryFolder folder;
  const Dataset spheres = make_sphere_dataset(folder.path / "spheres");
  const Dataset plane = make_street_dataset(folder.path / "plane", {.sizes = {{96, 54}},
                                                                    .fields_of_view = 2,
                                                                    .lenses_per_part = 2,
                                                                    .train_places = 1,
                                                                    .val_places = 1,
                                                                    .test_places = 2});
  train(spheres, folder.path / "deepcalib", one_epoch(Head::deepcalib_regression), false, {});
  train(plane, folder.path / "ours", one_epoch(Head::brown_conrady), false, {});
  const Predictor deepcalib(folder.path / "deepcalib"), ours(folder.path / "ours");
  CHECK(is_brown_conrady(plane, Part::test));
  CHECK_FALSE(is_brown_conrady(spheres, Part::test));

  for (const Predictor* predictor : {&deepcalib, &ours})
    for (const Dataset* dataset : {&spheres, &plane}) {
      INFO(to_string(predictor->card().options.head) << " on " << dataset->root.string());
      const RaySet set = ray_set(*dataset, Part::test);
      const RayEvaluation evaluation = evaluate_rays(*predictor, set, {.resamples = 20});
      CHECK(evaluation.images.size() == set.images.size());
      CHECK(evaluation.comparison.network.images == static_cast<int>(set.images.size()));
      CHECK(evaluation.comparison.training_mean.images == static_cast<int>(set.images.size()));
      // The same again, and everything in the files.
      CHECK(to_json(evaluate_rays(*predictor, set, {.resamples = 20})).dump() == to_json(evaluation).dump());
      const nlohmann::json json = nlohmann::json::parse(to_json(evaluation).dump());
      CHECK(json.at("images").size() == set.images.size());
      CHECK(json.at("rays").at("intervals_95").contains("turned_median_deg"));
      CHECK_THAT(to_html(evaluation), Catch::Contains("<svg") && !Catch::Contains("<script"));
      for (const RayEvaluatedImage& image : evaluation.images) {
        REQUIRE(image.predicted);
        CHECK(family_name(image.predicted->lens) ==
              (predictor == &deepcalib ? "unified_spherical" : "brown_conrady"));
      }
    }

  // The evaluation of single predictions.
  const RayEvaluation whole = evaluate_rays(deepcalib, ray_set(spheres, Part::test), {.resamples = 0});
  for (const RayEvaluatedImage& image : whole.images) {
    const std::vector<std::filesystem::path> file{image.image.file};
    const SpherePrediction one = predict_spheres(deepcalib, file).at(0);
    CHECK(one.camera.pinhole.fx == Approx(image.predicted->pinhole.fx).epsilon(1e-5));
    CHECK(one.errors.reprojection_px.has_value() == image.network.reprojection_px.has_value());
    if (one.errors.angles && image.network.angles)
      CHECK(one.errors.angles->mean_deg == Approx(image.network.angles->mean_deg).margin(1e-2));
  }

  // A Brown–Conrady evaluation has the same numbers in ray space, and its own as before.
  EvaluationSet flat = evaluation_set(plane, Part::test);
  for (EvaluationImage& image : flat.images) image.camera = "front";
  flat.images[0].camera = "another";
  const Evaluation evaluation = evaluate(ours, flat, {.resamples = 20});
  const RayEvaluation in_space = evaluate_rays(ours, ray_set(flat), {.resamples = 20});
  CHECK(to_json(evaluation.rays).dump() == to_json(in_space.comparison).dump());
  REQUIRE(evaluation.rays.by_camera.size() == 2);
  CHECK(evaluation.rays.by_camera[0].camera == "another");
  CHECK(evaluation.rays.by_camera[0].network.images == 1);
  CHECK_THAT(evaluation.report(), Catch::Contains("by camera"));
  CHECK(evaluation.rays.network.reprojection_mean_px ==
        Approx(evaluation.network.reprojection_mean_px).epsilon(1e-6));
  CHECK_THAT(evaluation.report(), Catch::Contains("in ray space"));
  CHECK_THROWS_WITH(evaluate(deepcalib, flat), Catch::Contains("predicts no Brown-Conrady lens"));

  // A picture of another size is named.
  RaySet wrong = ray_set(spheres, Part::test);
  wrong.images[0].file = plane.root / plane.images[0].file;
  CHECK_THROWS_WITH(evaluate_rays(deepcalib, wrong), Catch::StartsWith(wrong.images[0].file.string()));
  const RayEvaluation rest = evaluate_rays(deepcalib, wrong, {.resamples = 0, .skip_bad_images = true});
  CHECK(rest.images.size() == wrong.images.size() - 1);
  CHECK(rest.skipped.size() == 1);
}

TEST_CASE("views of one panorama are one cluster") {
  Dataset dataset{.root = "data", .groups = {}, .images = {}};
  for (int i = 0; i < 6; ++i) {
    DatasetGroup group;
    const std::string panorama = i < 2 ? "alley" : "square";
    group.folder = "64x64_panoramas/" + panorama + "_lens000" + std::to_string(i);
    group.label.rig_camera = panorama;
    dataset.groups.push_back(group);
    dataset.images.push_back({group.folder / "000000.png", i, Part::test});
  }
  const std::vector<int> all{0, 1, 2, 3, 4, 5};
  CHECK(place_clusters(dataset, all) == std::vector<int>{0, 0, 1, 1, 1, 1});
}

TEST_CASE("a folder of pictures may have a camera of any family") {
  const TemporaryFolder folder;
  write_file(folder.path / "a.png", std::string_view("x"));
  const ModelCamera camera{"dash", {640, 360, 300, 300, 319.5, 179.5}, UnifiedSpherical{.xi = .7}};
  const RaySet set = ray_set(folder.path, camera);
  REQUIRE(set.images.size() == 1);
  CHECK(set.images[0].truth->camera == camera);
  // The lens' picture, a circle 300 pixels wide, fills less than half of the frame.
  const ModelCamera small{"dash", {640, 360, 100, 100, 319.5, 179.5}, UnifiedSpherical{.xi = 1.2}};
  CHECK_THROWS_WITH(ray_set(folder.path, small), Catch::Contains("less than half"));
}
