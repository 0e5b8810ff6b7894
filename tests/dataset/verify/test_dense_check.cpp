#include <OpenImageIO/imagebufalgo.h>

#include <catch2/catch.hpp>

#include "dataset/verify/verify.h"
#include "tests/dataset/export/dense_dataset.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// A labelled dataset, and one of its images.
struct Labelled {
  Plan plan = small_plan({all_dense_labels.begin(), all_dense_labels.end()});
  TemporaryFolder folder = {};
  fs::path image = {};

  Labelled() {
    write_small_dataset(folder.path, plan);
    image = plan.groups[1].folder;
    for (const PlannedView& view : plan.views)
      if (std::ranges::count(view.groups, 1) > 0) {
        image /= image_name(plan, view);
        break;
      }
  }

  fs::path file(DenseLabel kind) const { return folder.path / dense_file(image, kind); }

  std::string faults() const {
    std::string joined;
    for (const std::string& fault : verify_dataset(folder.path).faults) joined += fault + "\n";
    return joined;
  }

  /// Writes other pixels with the hash that frames.csv should have for them.
  void replace(DenseLabel kind, const OIIO::ImageBuf& pixels) const {
    const std::string before = sha256(read_file(file(kind))), bytes = encode_dense(pixels, kind);
    write_file(file(kind), bytes);
    const fs::path table = file(kind).parent_path() / "frames.csv";
    std::string text = read_file(table);
    REQUIRE(text.find(before) != text.npos);
    text.replace(text.find(before), before.size(), sha256(bytes));
    write_file(table, text);
  }

  /// Adds to one pixel's first value.
  void shift(DenseLabel kind, float by) const {
    OIIO::ImageBuf pixels = read_dense(file(kind), kind);
    static_cast<float*>(pixels.pixeladdr(20, 10))[0] += by;
    replace(kind, pixels);
  }
};

}  // namespace

TEST_CASE("a dataset with every dense label verifies") {
  const Labelled labelled;
  const VerifySummary summary = verify_dataset(labelled.folder.path);
  CHECK(summary.faults == std::vector<std::string>{});
  CHECK(summary.dense == 8 * image_count(labelled.plan));
}

TEST_CASE("verify finds dense labels that are missing, damaged, of another size, or too many") {
  const Labelled labelled;
  const auto fault_is = [&](DenseLabel kind, const std::string& what) {
    CHECK_THAT(labelled.faults(), Catch::Contains(dense_file(labelled.image, kind).string() + ": " + what));
  };
  fs::remove(labelled.file(DenseLabel::depth));
  CHECK_THAT(labelled.faults(), Catch::Contains(dense_file(labelled.image, DenseLabel::depth).string()));

  std::string bytes = read_file(labelled.file(DenseLabel::normal));
  bytes[bytes.size() / 2] ^= 1;
  write_file(labelled.file(DenseLabel::normal), bytes);
  fault_is(DenseLabel::normal, "its bytes do not match normal_sha256");

  OIIO::ImageBuf small(OIIO::ImageSpec(5, 5, 1, OIIO::TypeDesc::UINT16));
  OIIO::ImageBufAlgo::zero(small);
  labelled.replace(DenseLabel::instance, small);
  fault_is(DenseLabel::instance, "its size contradicts calibration.json");

  const fs::path stray = labelled.image.parent_path() / "999999.depth.exr";
  write_file(labelled.folder.path / stray, "x");
  CHECK_THAT(labelled.faults(),
             Catch::Contains(stray.string() + ": is a dense label that the dataset does not"));
}

TEST_CASE("verify computes dense labels again where the label and the pose decide them") {
  for (const DenseLabel kind : {DenseLabel::rays, DenseLabel::up, DenseLabel::latitude}) {
    const Labelled labelled;
    labelled.shift(kind, 1e-3f);
    CHECK_THAT(labelled.faults(), Catch::Contains(dense_file(labelled.image, kind).string() +
                                                  ": contradicts calibration.json and the pose"));
  }
  const Labelled labelled;
  labelled.shift(DenseLabel::depth, 0.01f);
  labelled.shift(DenseLabel::normal, 0.01f);
  OIIO::ImageBuf semantic = read_dense(labelled.file(DenseLabel::semantic), DenseLabel::semantic);
  *static_cast<std::uint16_t*>(semantic.pixeladdr(3, 3)) = 8;
  labelled.replace(DenseLabel::semantic, semantic);
  const std::string faults = labelled.faults();
  CHECK_THAT(faults, Catch::Contains("depth.exr: contradicts the label distance"));
  CHECK_THAT(faults, Catch::Contains("normal.exr: holds normals that are no unit vectors"));
  CHECK_THAT(faults, Catch::Contains("semantic.png: holds a class that its scene"));
}
