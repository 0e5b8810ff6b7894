#include <catch2/catch.hpp>

#include "files/files.h"
#include "production/drive_text.h"
#include "tests/production/tiny_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("a job reads back from its folder as it was begun") {
  const TinyDataset dataset;
  begin_job(dataset.root, dataset.job.text);
  DatasetJob again = job_of_folder(dataset.root);
  CHECK(again.text.recipe == dataset.job.text.recipe);
  CHECK(to_text(again.recipe) == to_text(dataset.job.recipe));
  CHECK(to_text(again.rig) == to_text(dataset.job.rig));
  REQUIRE(again.scenes.size() == 1);
  CHECK(fs::equivalent(again.scenes[0].file, dataset.scene));
  CHECK(has_scenes(again));
  prepare_scenes(again, dataset.root);
  CHECK(again.scene_sha256 == std::vector<std::string>{sha256(read_file(dataset.scene))});
}

TEST_CASE("a scene that changed after the job was begun is refused, and a lost one is missed") {
  TinyDataset dataset;
  prepare_scenes(dataset.job, dataset.root);
  begin_job(dataset.root, dataset.job.text);
  write_file(dataset.scene, read_file(dataset.scene) + " ");
  DatasetJob again = job_of_folder(dataset.root);
  CHECK_THROWS_WITH(prepare_scenes(again, dataset.root), Catch::Contains("street.gltf"));
  fs::remove(dataset.scene);
  CHECK_FALSE(has_scenes(again));
  CHECK_THROWS_WITH(prepare_scenes(again, dataset.root), Catch::Contains("there is no such file"));
}

TEST_CASE("planning stops where its watch says so") {
  const TinyDataset dataset;
  CHECK_THROWS_AS(plan_of(dataset.job, {.must_stop = [] { return true; }}), Interrupted);
}

TEST_CASE("a shard looks at the scenes of its own views alone, and all shards make one dataset") {
  const TinyDataset whole{.scene_count = 4};
  whole.make();
  for (std::int64_t count : {1, 2, 4, 7, 30}) {
    const TinyDataset dataset{.scene_count = 4};
    for (std::int64_t i = 0; i < count; ++i) {
      const Shard shard{i, count};
      INFO("shard " << to_string(shard));
      DatasetJob job = dataset.job;
      Plan plan = outline_of(job);
      const std::vector<std::int64_t> views = remaining_views(plan, shard, dataset.root, {}).views;
      std::set<std::string> expected, loaded;
      for (std::int64_t v : views)
        expected.insert(plan.scenes[plan.conditions[plan.views[v].condition].scene].file.string());
      CHECK(expected.size() <= std::max<std::size_t>(2, 4 / count + 1));
      // No other scene can be loaded.
      for (const fs::path& scene : dataset.scenes)
        if (!expected.contains(scene.string())) fs::rename(scene, scene.string() + ".away");
      prepare_views(job, plan, views, dataset.root,
                    {.scene_loaded = [&](const fs::path& file, const DrivenScene&) {
                      CHECK(loaded.insert(file.string()).second);
                    }});
      CHECK(loaded == expected);
      begin_job(dataset.root, job.text);
      Journal journal(dataset.root, shard);
      CHECK(make_views(plan, views, journal, dataset.root, 2, {}).views ==
            static_cast<std::int64_t>(views.size()));
      for (const fs::path& scene : dataset.scenes)
        if (fs::exists(scene.string() + ".away")) fs::rename(scene.string() + ".away", scene);
    }
    CHECK(dataset.contents() == whole.contents());
    DatasetJob job = job_of_folder(dataset.root);  // as finish has it
    prepare_scenes(job, dataset.root);
    CHECK(read_job(dataset.root).scenes == job.text.scenes);
  }
}

TEST_CASE("a scene that changed between two shards is refused by the second that uses it, and by finish") {
  const TinyDataset dataset{.scene_count = 2};
  const auto begin = [&](std::int64_t i) {
    DatasetJob job = dataset.job;
    Plan plan = outline_of(job);
    prepare_views(job, plan, remaining_views(plan, {i, 4}, dataset.root, {}).views, dataset.root, {});
    begin_job(dataset.root, job.text);
  };
  begin(0);
  write_file(dataset.scenes[0], read_file(dataset.scenes[0]) + " ");
  begin(2);  // uses the second scene
  CHECK_THROWS_WITH(begin(1), Catch::Contains("sha256 of street.gltf"));
  DatasetJob job = job_of_folder(dataset.root);
  CHECK_THROWS_WITH(prepare_scenes(job, dataset.root), Catch::Contains("sha256 of street.gltf"));
}

TEST_CASE("drives read back from their text, and impossible ones are refused") {
  const TemporaryFolder folder;
  const fs::path route = folder.path / "route.csv";
  write_file(route, std::string("x,y,z\n0,0,0\n"));
  for (const DriveOptions& drive :
       {DriveOptions{}, DriveOptions{.metres_per_unit = 0.0254, .route = route}}) {
    const DriveOptions again = drive_from_text(to_text(drive));
    CHECK(again.metres_per_unit == drive.metres_per_unit);
    CHECK(again.route == drive.route);
  }
  Recipe recipe;
  recipe.scenes = {"a.glb"};
  CHECK(fault_of({}, recipe) == "");
  CHECK(fault_of({.metres_per_unit = 0.01, .route = route}, recipe) == "");
  CHECK_THAT(fault_of({.metres_per_unit = -1, .route = {}}, recipe), Catch::StartsWith("metres_per_unit: "));
  recipe.cities = 1;
  CHECK_THAT(fault_of({.metres_per_unit = 0, .route = route}, recipe), Catch::StartsWith("route: "));
}
