#include <atomic>
#include <catch2/catch.hpp>

#include "dataset/dense/dense_file.h"
#include "dataset/pixels/image_file.h"
#include "production/costs/pilot.h"
#include "tests/production/tiny_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// Six views through four fisheyes each, most of which show all of their square images, and some do not.
void make_fisheyes(TinyDataset& dataset) {
  Recipe& recipe = dataset.job.recipe;
  recipe.base_hfov_deg.clear();
  recipe.hfov_deg = {195};
  recipe.sizes = {{40, 40}};
  recipe.lens_model = "kannala_brandt";
  recipe.undistorted = false;
  recipe.lenses = 4;
  recipe.labels = {DenseLabel::depth, DenseLabel::semantic};
  REQUIRE(recipe.fault() == "");
  dataset.plan = plan_of(dataset.job, {});
}

struct FisheyeJob : TinyDataset {
  FisheyeJob() { make_fisheyes(*this); }

  /// Makes what remains of a shard, as generate does.
  void make_shard(const Shard& shard, int threads) const {
    Journal journal(root, shard);
    const std::vector<std::int64_t> views = remaining_views(plan, shard, root, {}).views;
    write_labels(plan, views, root);
    make_views(plan, views, journal, root, threads, {});
  }
};

const std::map<std::string, std::string>& whole_fisheyes() {
  static const std::map<std::string, std::string> contents = [] {
    const FisheyeJob job;
    job.make_shard({}, 2);
    return job.contents();
  }();
  return contents;
}

}  // namespace

TEST_CASE("images of another family have labels and dense labels and where needed masks") {
  const FisheyeJob job;
  job.make_shard({}, 1);
  const auto files = job.contents();
  CHECK(files == whole_fisheyes());  // made by two threads
  CHECK(job.remaining().empty());
  int masks = 0, images = 0;
  for (const PlannedGroup& group : job.plan.groups) {
    const nlohmann::json label = nlohmann::json::parse(files.at(group.folder + "/calibration.json"));
    CHECK(label["model"] == "kannala_brandt");
    CHECK(label.contains("valid") == files.contains(group.folder + "/valid.png"));
    masks += label.contains("valid");
  }
  CHECK(masks > 0);
  CHECK(masks < static_cast<int>(job.plan.groups.size()));
  for (std::int64_t v = 0; v < 6; ++v)
    for (const std::string& file : job.files_of(v)) {
      ++images;
      CHECK(files.contains(dense_file(file, DenseLabel::depth).string()));
      CHECK(files.contains(dense_file(file, DenseLabel::semantic).string()));
      const fs::path mask_file = fs::path(file).parent_path() / "valid.png";
      if (!files.contains(mask_file.string())) continue;
      const OIIO::ImageBuf image = read_pixels(job.root / file), mask = read_pixels(job.root / mask_file);
      const auto* code = static_cast<const std::uint8_t*>(image.localpixels());
      const auto* valid = static_cast<const std::uint8_t*>(mask.localpixels());
      int lit = 0;
      for (int i = 0; i < 40 * 40; ++i) {
        const bool is_black = code[3 * i] == 0 && code[3 * i + 1] == 0 && code[3 * i + 2] == 0;
        if (valid[i] == 0) CHECK(is_black);
        lit += valid[i] != 0 && !is_black;
      }
      CHECK(lit > 800);
    }
  CHECK(images == 24);
}

TEST_CASE("shards of another family's dataset make the bytes that one process makes") {
  const FisheyeJob job;
  for (std::int64_t i = 0; i < 3; ++i) job.make_shard({i, 3}, 2);
  CHECK(job.contents() == whole_fisheyes());
}

TEST_CASE("a run through fisheyes that is stopped again and again is completed with the same bytes") {
  const FisheyeJob job;
  write_labels(job.plan, job.remaining(), job.root);
  // It is asked before each view and after each tile: the runs stop at ever later moments.
  int runs = 0;
  for (; !job.remaining().empty(); ++runs) {
    std::atomic<int> asked = 0;
    job.make({.must_stop = [&] { return ++asked > 15 * (runs + 1); }});
    REQUIRE(runs < 100);
  }
  CHECK(runs > 1);
  CHECK(job.contents() == whole_fisheyes());
}

TEST_CASE("a view whose traced image was lost is made again and no other") {
  const FisheyeJob job;
  job.make_shard({}, 2);
  fs::remove(job.root / job.files_of(2)[1]);
  CHECK(job.remaining() == std::vector<std::int64_t>{2});
  job.make();
  CHECK(job.contents() == whole_fisheyes());
}

TEST_CASE("the pilot of a plan measures traced views") {
  const FisheyeJob job;
  const Pilot pilot = run_pilot(job.job.recipe, job.job.rig, job.job.drive, 1, {});
  CHECK(pilot.full_size_views >= 1);
  CHECK(pilot.images == 4 * pilot.full_size_views);
  REQUIRE(pilot.render_cpu_s.size() == 1);
  CHECK(pilot.render_cpu_s[0].at(0) > 0);
  CHECK(pilot.full_size_ratio == Approx(1));  // the images are too small to be reduced
  CHECK(pilot.view_bytes == 4 * 40 * 40 * 12);
  CHECK(pilot.image_costs[0].bytes > 0);
}
