#include <ATen/ATen.h>

#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/model/predictor.h"
#include "trainer/training/distillation.h"
#include "trainer/training/samples.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

TrainOptions brief(int epochs) {
  TrainOptions options;
  options.reduction.width = 64;
  options.epochs = epochs;
  options.batch_size = 8;
  options.mirror = false;
  options.threads = 2;
  return options;
}

/// Eight images, and a teacher of the other target space that has learned a little about them.
struct School {
  TemporaryFolder folder;
  Dataset dataset;
  Samples samples;
  School() {
    dataset = make_street_dataset(folder.path / "data", {.sizes = {{96, 54}},
                                                         .fields_of_view = 4,
                                                         .lenses_per_part = 2,
                                                         .train_places = 1,
                                                         .val_places = 1,
                                                         .test_places = 1});
    TrainOptions options = brief(4);
    options.target_space = TargetSpace::raw;
    train(dataset, folder.path / "teacher", options, false, {});
    samples = load_samples(dataset, Part::train, {.reduction = options.reduction}, folder.path / "samples");
  }
  std::string teacher() const { return (folder.path / "teacher").string(); }
  std::vector<BatchImage> images() const {
    std::vector<BatchImage> images;
    for (std::size_t i = 0; i < samples.targets.size(); ++i)
      images.push_back({samples.cache.images[i], samples.cache.originals[i]});
    return images;
  }
};

/// Made once: the tests only add models of their own.
const School& the_school() {
  static const School school;
  return school;
}

}  // namespace

TEST_CASE("a teacher's predictions are converted to the student's units") {
  const School& school = the_school();
  ModelCard student;
  student.options.reduction.width = 64;
  student.options.teacher = school.teacher();
  student.targets = fit_standardisation(school.samples.targets);  // of apparent coefficients
  const auto teacher = load_teacher(student.options);
  const std::vector<BatchImage> images = school.images();

  torch::Tensor same = torch::empty({static_cast<long>(images.size()), output_count});
  const std::vector<Outputs> said = (*teacher)(images);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Outputs answer =
        standardise(convert(said[i], TargetSpace::raw, TargetSpace::apparent, 96, 54), student.targets);
    for (int k = 0; k < output_count; ++k) same[i][k] = answer[k];
  }
  CHECK(distillation_loss(same, *teacher, images, student).item<double>() == Approx(0).margin(1e-10));
  CHECK(distillation_loss(same + 2, *teacher, images, student).item<double>() == Approx(4).epsilon(1e-5));

  student.options.outputs = {"fov"};  // the others do not count
  same.slice(1, 1).fill_(7);
  CHECK(distillation_loss(same, *teacher, images, student).item<double>() == Approx(0).margin(1e-10));
}

TEST_CASE("a student that learns from its teacher alone approaches the teacher's predictions") {
  const School& school = the_school();
  TrainOptions options = brief(15);
  options.teacher = school.teacher();
  options.teacher_weight = 1;
  const TrainSummary summary = train(school.dataset, school.folder.path / "student", options, false, {});
  CHECK(summary.epochs.back().training_loss < .2 * summary.epochs.front().training_loss);

  // The teacher has hardly learned, so the student ends nearer to it than to the labels.
  CHECK(summary.epochs.back().training_loss < .3 * summary.epochs.back().validation_loss);
  CHECK(load_model_card(school.folder.path / "student").options.teacher == school.teacher());
}

TEST_CASE("a teacher without weight changes nothing, and a taught run resumes bit for bit") {
  const School& school = the_school();
  const auto weights = [&](const char* name, TrainOptions options, bool interrupted) {
    const auto model = school.folder.path / name;
    train(school.dataset, model, options, false, [&](const EpochReport&) { return !interrupted; });
    if (interrupted) train(school.dataset, model, {}, true, {});
    return read_file(model / "weights.pt");
  };
  TrainOptions options = brief(2);
  const std::string alone = weights("alone", options, false);
  options.teacher = school.teacher();
  options.teacher_weight = 0;
  CHECK(weights("unheard", options, false) == alone);
  options.teacher_weight = .5;
  const std::string taught = weights("taught", options, false);
  CHECK(taught != alone);
  CHECK(weights("interrupted", options, true) == taught);
}

TEST_CASE("a teacher that cannot teach is refused in one line") {
  const School& school = the_school();
  TrainOptions student = brief(1);
  CHECK(load_teacher(student) == nullptr);
  student.teacher = (school.folder.path / "nobody").string();
  CHECK_THROWS_WITH(load_teacher(student), Catch::Contains("model.json: is missing"));
  student.teacher = school.teacher();
  student.reduction.width = 80;
  CHECK_THROWS_WITH(load_teacher(student), Catch::Contains("images of another size"));

  TrainOptions narrow = brief(1);
  narrow.outputs = {"fov"};
  train(school.dataset, school.folder.path / "narrow", narrow, false, {});
  student = brief(1);
  student.teacher = (school.folder.path / "narrow").string();
  CHECK_THROWS_WITH(load_teacher(student), Catch::Contains("has not learned k1"));
}
