#include <catch2/catch.hpp>
#include <map>

#include "dataset/job/job.h"
#include "dataset/job/journal.h"
#include "dataset/job/write_label.h"
#include "dataset/migrate/migrate.h"
#include "dataset/verify/verify.h"
#include "dataset/verify/verify_plan.h"
#include "tests/dataset/labels/old_label.h"
#include "tests/dataset/old_dataset.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// One camera that is not level, and streets whose names need quotes.
Plan tilted_plan() {
  return make_plan(small_plan().recipe, Rig{.cameras = {{.name = "front", .pitch_deg = -8, .roll_deg = 11}}},
                   {{.file = "plain.glb"}}, [](const fs::path&) {
                     Scene scene = plain_scene(6);
                     for (Lane& lane : scene.lanes) lane.street += ",\n\"second\" line";
                     return DrivenScene{.scene = scene};
                   });
}

/// The bytes of every file of a dataset but locks, by name.
std::map<std::string, std::string> contents(const fs::path& root) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path name = entry.path().lexically_relative(root);
    if (entry.is_regular_file() && *name.begin() != ".cps") files[name.string()] = read_file(entry.path());
  }
  return files;
}

void copy_folder(const fs::path& from, const fs::path& to) {
  fs::copy(from, to, fs::copy_options::recursive);
}

/// A dataset as it is made today, and as it was in schema 1.
struct TwoForms {
  TemporaryFolder temporary;
  fs::path today = temporary.path / "today", old = temporary.path / "old";
  Plan plan = tilted_plan();
  TwoForms() {
    write_small_dataset(today, plan);
    copy_folder(today, old);
    make_old(old);
  }
  fs::path label(const fs::path& root, std::size_t group) const {
    return root / plan.groups[group].folder / "calibration.json";
  }
};

std::int64_t migrate(const fs::path& root) {
  return migrate_dataset(root, [](const std::string&) {});
}

bool verifies(const fs::path& root, const Plan& plan) {
  return verify_dataset(root).faults.empty() && faults_against_plan(root, plan).empty();
}

}  // namespace

TEST_CASE("a migrated dataset has the bytes of one that is made today") {
  const TwoForms forms;
  const auto groups = static_cast<std::int64_t>(forms.plan.groups.size());
  CHECK(read_json(forms.label(forms.old, 0))["schema"] == 1);
  CHECK(read_file(forms.old / forms.plan.groups[0].folder / "frames.csv").find("gravity") ==
        std::string::npos);
  CHECK(verifies(forms.old, forms.plan));
  std::int64_t folders = 0;
  CHECK(migrate_dataset(forms.old, [&](const std::string&) { ++folders; }) == 2 * groups + 1);
  CHECK(folders == groups);
  CHECK(contents(forms.old) == contents(forms.today));
  CHECK(verifies(forms.old, forms.plan));
  CHECK(migrate(forms.old) == 0);
  CHECK(contents(forms.old) == contents(forms.today));
}

TEST_CASE("a migration that is stopped leaves a whole dataset, and goes on to the same bytes") {
  const TwoForms forms;
  const std::size_t groups = forms.plan.groups.size();
  for (std::size_t stop : {std::size_t{1}, groups / 2, groups}) {
    const TemporaryFolder folder;
    const fs::path root = folder.path / "data";
    copy_folder(forms.old, root);
    std::size_t folders = 0;
    CHECK_THROWS_WITH(migrate_dataset(root,
                                      [&](const std::string&) {
                                        if (++folders == stop) throw std::runtime_error("stopped");
                                      }),
                      "stopped");
    CHECK(read_json(root / "dataset.json")["schema"] == 1);
    CHECK(verifies(root, forms.plan));
    CHECK(migrate(root) == static_cast<std::int64_t>(2 * (groups - stop) + 1));
    CHECK(contents(root) == contents(forms.today));
  }
}

TEST_CASE("a migration that was killed between the files of a folder goes on, too") {
  const TwoForms forms;
  const fs::path leaf = forms.old / forms.plan.groups[1].folder;
  fs::copy_file(forms.label(forms.today, 1), leaf / "calibration.json", fs::copy_options::overwrite_existing);
  write_file(leaf / "frames.csv.0123abcd-7.tmp", std::string("file,part"));
  CHECK(migrate(forms.old) == static_cast<std::int64_t>(2 * forms.plan.groups.size()));
  CHECK(contents(forms.old) == contents(forms.today));
}

TEST_CASE("a set of cps relens, which has labels and lists only, is migrated; what it says besides is kept") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "480x270_hfov090/front_lens0026/calibration.json";
  for (const char* part : {"train", "val", "test"})
    write_file(folder.path / "splits" / (std::string(part) + ".txt"), {});
  const Label label = label_from_json(nlohmann::json::parse(old_label), "x");
  write_file(file, old_label);
  CHECK(migrate(folder.path) == 1);
  CHECK(read_file(file) == to_json(label).dump(2) + "\n");
  CHECK(migrate(folder.path) == 0);

  auto noted = nlohmann::ordered_json::parse(old_label);
  noted["note"] = "kept";
  write_json(file, noted);
  CHECK(migrate(folder.path) == 1);
  nlohmann::ordered_json expected = to_json(label);
  expected["note"] = "kept";
  CHECK(read_file(file) == expected.dump(2) + "\n");
}

TEST_CASE("a folder that cannot be migrated is refused before anything in it changes") {
  const TwoForms forms;
  const auto refused = [&](const std::string& why) {
    const auto before = contents(forms.old);
    CHECK_THROWS_WITH(migrate(forms.old), Catch::Contains(why));
    CHECK(contents(forms.old) == before);
  };
  {
    const FileLock working(folder_lock(forms.old), FileLock::Kind::shared);
    refused("other processes still work there");
    CHECK_THROWS_AS(migrate(forms.old), HeldByAnother);
  }
  const auto with = [&](const fs::path& file, const char* key, int value, const std::string& why) {
    const std::string before = read_file(file);
    auto json = nlohmann::ordered_json::parse(before);
    json[key] = value;
    write_json(file, json);
    refused(why);
    write_file(file, before);
  };
  with(forms.old / "dataset.json", "schema", 3, "dataset.json: schema: is neither 1 nor 2");
  with(forms.label(forms.old, forms.plan.groups.size() - 1), "schema", 3,
       "calibration.json: schema: is neither 1 nor 2");
  with(forms.label(forms.old, forms.plan.groups.size() - 1), "cx", -9, "calibration.json: cx: contradicts");

  begin_job(forms.old, {.recipe = "", .rig = "", .drive = ""});
  fs::remove(forms.old / "dataset.json");
  refused("is not finished; run cps generate again");
}

TEST_CASE("a job that an older program began goes on, and its dataset has today's bytes") {
  const TwoForms forms;
  const fs::path begun = forms.temporary.path / "begun";
  for (std::size_t g = 0; g < forms.plan.groups.size(); g += 2) {
    fs::create_directories(begun / forms.plan.groups[g].folder);
    fs::copy_file(forms.label(forms.old, g), forms.label(begun, g));
  }
  write_small_dataset(begun, forms.plan);
  CHECK(contents(begun) == contents(forms.today));

  // A label of today is left alone, one of tomorrow refused.
  const fs::path label = forms.label(begun, 0);
  write_file(label, read_file(label) + " ");
  const std::string there = read_file(label);
  write_label(begun, forms.plan, forms.plan.groups[0]);
  CHECK(read_file(label) == there);
  nlohmann::json json = read_json(label);
  json["schema"] = 3;
  write_json(label, json);
  CHECK_THROWS_WITH(write_label(begun, forms.plan, forms.plan.groups[0]),
                    Catch::Contains("calibration.json: schema: is neither 1 nor 2"));
}
