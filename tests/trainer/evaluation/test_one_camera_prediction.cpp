#include <catch2/catch.hpp>
#include <set>

#include "distortion/certificate/frame_certificate.h"
#include "numbers/angles.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/onnx/random_model.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/camera_numbers.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/evaluation/one_camera_prediction.h"
#include "trainer/evaluation/predict.h"

using namespace cps;

namespace {

/// A network that has learned nothing.
Predictor random_predictor(const std::filesystem::path& folder, Head head) {
  TrainOptions options;
  options.head = head;
  options.architecture = "resnet18-16";
  options.reduction.width = 80;
  if (is_fit(head)) {
    options.target_space = TargetSpace::seen;
    options.orientation.measured = true;
  }
  write_random_model(folder, options);
  return Predictor(folder);
}

/// Test images of two lenses, five of each.
Dataset two_lenses(const std::filesystem::path& root) {
  return make_street_dataset(root, {.sizes = {{160, 90}},
                                    .fields_of_view = 1,
                                    .lenses_per_part = 2,
                                    .train_places = 1,
                                    .val_places = 1,
                                    .test_places = 5});
}

std::vector<std::filesystem::path> test_files_of(const Dataset& dataset, std::size_t lens) {
  std::vector<std::filesystem::path> files;
  std::set<int> groups;
  for (const DatasetImage& image : dataset.images) {
    if (image.part != Part::test) continue;
    groups.insert(image.group);
    if (groups.size() == lens + 1) files.push_back(dataset.root / image.file);
  }
  return files;
}

}  // namespace

TEST_CASE("pictures of a camera make one prediction with deviations") {
  const TemporaryFolder folder;
  const Dataset dataset = two_lenses(folder.path / "data");
  const Predictor predictor = random_predictor(folder.path / "model", Head::brown_conrady_fit);
  const std::vector<std::filesystem::path> files = test_files_of(dataset, 1);
  REQUIRE(files.size() == 5);
  const OneCameraPrediction prediction = predict_one_camera(predictor, files);
  REQUIRE(prediction.truth);
  CHECK(prediction.reprojection_px);
  for (double deviation : prediction.deviation) CHECK(deviation > 0);
  const CalibratedCamera& certified = prediction.camera.certified.camera;
  CHECK(certify_frame(certified.distortion, certified.pinhole).valid());
  CHECK(prediction.convergence.back().frames == 5);
  CHECK(prediction.convergence.back().posterior.deviation() == prediction.deviation);

  const nlohmann::ordered_json json = to_json(prediction);
  CHECK(json == to_json(predict_one_camera(predictor, files)));
  CHECK(json.at("pictures") == 5);
  CHECK(json.at("frames").size() == 5);
  CHECK(json.at("frames")[4].at("file") == files[4].string());
  CHECK(json.at("convergence").size() == 4);
  CHECK(json.at("calibration").at("fov") == degrees(hfov_rad(prediction.fitted.pinhole)));
  CHECK(json.at("truth") == numbers_json(*prediction.truth));
  CHECK(json.at("posterior").at("covariance").size() == output_count);
  CHECK_THAT(report(prediction), Catch::StartsWith("one camera from 5 pictures (160x90)\n") &&
                                     Catch::Contains("deviation") && Catch::Contains("of 5 pictures agree"));
  CHECK_THAT(convergence_svg(prediction), Catch::StartsWith("<svg") && Catch::Contains("H-FOV"));

  // One picture gives what the network says of it alone.
  const OneCameraPrediction single = predict_one_camera(predictor, std::span(files).first(1));
  CHECK(single.convergence.size() == 1);
  CHECK(single.camera.trusted_frames() == 1);
  const ImagePrediction alone = predict_images(predictor, std::span(files).first(1), {.variants = 0}).at(0);
  REQUIRE(alone.camera);
  CHECK(single.fitted.pinhole.fx == Approx(alone.camera->pinhole.fx).epsilon(.02));
  CHECK(single.deviation[0] == Approx((*alone.deviation)[0]).epsilon(.05));
}

TEST_CASE("pictures of several sizes or of several known cameras are not one camera") {
  const TemporaryFolder folder;
  const Dataset dataset = two_lenses(folder.path / "data");
  std::vector<std::filesystem::path> files = test_files_of(dataset, 0);
  CHECK(common_size(files) == ImageSize{160, 90});
  CHECK(common_truth(files, {160, 90}));
  const std::filesystem::path other = test_files_of(dataset, 1).front(), small = folder.path / "small.png";
  files.push_back(other);
  CHECK_THROWS_WITH(common_truth(files, {160, 90}),
                    Catch::StartsWith(other.string() +
                                      ": its calibration.json is of another camera than "
                                      "that beside " +
                                      files.front().string()));
  write_png(render_street(draw_calibration({80, 45}, 70, 1), 1), small);
  CHECK_FALSE(common_truth(std::vector{small}, {80, 45}));
  files.push_back(small);
  CHECK_THROWS_WITH(common_size(files), small.string() + ": is 80x45, but " + files.front().string() +
                                            " is 160x90: pictures of one camera must have one size");
  files.back() = folder.path / "none.png";
  CHECK_THROWS_WITH(common_size(files), Catch::StartsWith(files.back().string() + ": cannot be read"));
}

TEST_CASE("an evaluation joins the images of each camera") {
  const TemporaryFolder folder;
  const Dataset dataset = two_lenses(folder.path / "data");
  const Predictor predictor = random_predictor(folder.path / "model", Head::brown_conrady_fit);
  const EvaluationSet set = evaluation_set(dataset, Part::test);
  const Evaluation evaluation = evaluate(predictor, set, {.resamples = 0, .per_camera = true});
  REQUIRE(evaluation.cameras.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const CameraEvaluation& camera = evaluation.cameras[k];
    const std::vector<std::filesystem::path> files = test_files_of(dataset, k);
    CHECK(dataset.root / camera.name == files.front().parent_path());
    CHECK(camera.frames == 5);
    const OneCameraPrediction joint = predict_one_camera(predictor, files);
    CHECK(camera.trusted_frames == joint.camera.trusted_frames());
    CHECK(camera.hfov_deg.joint ==
          Approx(degrees(std::abs(hfov_rad(joint.fitted.pinhole) - hfov_rad(camera.truth.pinhole))))
              .margin(1e-3));
    CHECK(camera.hfov_deg.deviation == Approx(degrees(joint.deviation[0])).epsilon(1e-3));
    CHECK(camera.reprojection_px.joint == Approx(joint.reprojection_px.value()).epsilon(1e-3));
    double single = 0;
    for (const EvaluatedImage& image : evaluation.images)
      if (image.image.taken_by == camera.name) single += std::abs(image.network.apparent[1]) / 5;
    CHECK(camera.k1.single_mean == Approx(single));
    CHECK(camera.k1.is_within(2) >= camera.k1.is_within(1));
  }
  CHECK_THAT(evaluation.report(),
             Catch::Contains("one camera from all its") && Catch::Contains("mean of 2 cameras"));
  const nlohmann::ordered_json json = to_json(evaluation);
  CHECK(json.at("cameras").size() == 2);
  CHECK(json.at("cameras")[1].at("k1_error").contains("within_two"));
  CHECK_FALSE(json.at("cameras")[1].at("reprojection_px").contains("deviation"));
  CHECK_THAT(to_html(evaluation), Catch::Contains("reprojection error of each camera"));

  CHECK_FALSE(to_json(evaluate(predictor, set, {.resamples = 0})).contains("cameras"));
  const Predictor direct = random_predictor(folder.path / "direct", Head::brown_conrady);
  CHECK_THROWS_WITH(evaluate(direct, set, {.resamples = 0, .per_camera = true}), Catch::Contains("no fit"));
  CHECK_THROWS_WITH(predict_one_camera(direct, test_files_of(dataset, 0)), Catch::Contains("no fit"));
}
