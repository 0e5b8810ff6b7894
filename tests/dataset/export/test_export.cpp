#include <catch2/catch.hpp>

#include "files/file_lock.h"
#include "tests/dataset/edit_csv.h"
#include "tests/dataset/export/exported.h"
#include "tests/dataset/export/stopped_export.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

constexpr std::array all_targets = {ExportTarget::webdataset, ExportTarget::huggingface, ExportTarget::colmap,
                                    ExportTarget::nerfstudio, ExportTarget::kitti,       ExportTarget::coco};

std::size_t images_below(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& [name, bytes] : bytes_of(folder)) count += name.ends_with(".png");
  return count;
}

}  // namespace

TEST_CASE("targets are named, and others refused with the list of those") {
  for (ExportTarget target : all_targets) CHECK(export_target_from_string(to_string(target)) == target);
  CHECK_THROWS_WITH(export_target_from_string("voc"),
                    "is none of webdataset, huggingface, colmap, nerfstudio, kitti, coco");
}

TEST_CASE("options that a target has no use for, and unusable ones, are refused") {
  const auto fault = [](ExportOptions options) { return options.fault(); };
  using enum ExportTarget;
  CHECK(fault({}).empty());
  CHECK_THAT(fault({.shard_mb = 0}), Catch::StartsWith("shard_mb: must lie in [1, "));
  CHECK_THAT(fault({.target = colmap, .license = "mit"}), Catch::StartsWith("license: is for --to hugging"));
  CHECK_THAT(fault({.target = huggingface, .license = "do what you like"}), Catch::StartsWith("license: "));
  CHECK_THAT(fault({.target = huggingface, .creator = "a\nb"}), Catch::StartsWith("creator: must not have"));
  CHECK_THAT(fault({.target = huggingface, .published = "2.5.26"}), Catch::StartsWith("published: "));
  CHECK(fault({.target = huggingface, .license = "cc-by-4.0", .published = "2026-05-02"}).empty());
}

TEST_CASE("the same dataset gives the same bytes, and a finished export is left alone") {
  const Labelled exported;
  for (ExportTarget target : all_targets) {
    const fs::path a = exported.temporary.path / "a", b = exported.temporary.path / "b";
    INFO(to_string(target));
    CHECK_FALSE(exported.write(a, {.target = target}).was_finished);
    exported.write(b, {.target = target, .copy = true});
    CHECK(bytes_of(a) == bytes_of(b));
    CHECK_FALSE(fs::exists(a / ".cps"));
    CHECK(exported.write(a, {.target = target}).was_finished);
    fs::remove_all(a);
    fs::remove_all(b);
  }
}

TEST_CASE("an export that was stopped goes on where it was, and nobody takes it for finished") {
  const Labelled exported;
  for (ExportTarget target : all_targets) {
    const ExportOptions options{.target = target, .shard_mb = 1};
    const fs::path whole = exported.temporary.path / "whole", part = exported.temporary.path / "part";
    exported.write(whole, options);
    for (int stop = 1; stop <= 3; ++stop) {
      INFO(to_string(target) << ", stop " << stop);
      CHECK_THROWS_AS(exported.write(part, options, stop_after(stop)), Stopped);
      CHECK_FALSE(fs::exists(part / "export.json"));
      write_file(part / "left.png.0123abcd-1.tmp", std::string("of a killed process"));
      exported.write(part, options);
      CHECK(bytes_of(part) == bytes_of(whole));
      fs::remove_all(part);
    }
    fs::remove_all(whole);
  }
}

TEST_CASE("images are links to the dataset's, or copies on request") {
  const Exported exported;
  const fs::path linked = exported.temporary.path / "linked", copied = exported.temporary.path / "copied";
  exported.write(linked, {.target = ExportTarget::huggingface});
  exported.write(copied, {.target = ExportTarget::huggingface, .copy = true});
  const DatasetImage image = read_dataset(exported.root).images.front();
  const fs::path name = to_string(image.part) / image.file;
  CHECK(fs::equivalent(exported.root / image.file, linked / name));
  CHECK_FALSE(fs::equivalent(exported.root / image.file, copied / name));
  CHECK(images_below(linked) == read_dataset(exported.root).images.size());
}

TEST_CASE("folders that hold other things, the dataset's own and files are refused") {
  const Exported exported;
  const auto refuses = [&](const fs::path& out, const char* expected) {
    CHECK_THROWS_WITH(exported.write(out, {}), Catch::Contains(expected));
  };
  refuses(exported.root, "lies in the dataset itself");
  refuses(exported.root / "new" / "folder", "lies in the dataset itself");
  refuses(exported.root / ".." / "data", "lies in the dataset itself");
  CHECK_FALSE(fs::exists(exported.root / "new"));
  refuses(exported.temporary.path, "holds other things");
  write_file(exported.temporary.path / "file", std::string("1"));
  refuses(exported.temporary.path / "file", "is a file: name a folder");
  write_file(exported.temporary.path / "job" / ".cps" / "job.json", std::string("{}"));
  refuses(exported.temporary.path / "job", "holds a dataset");
  CHECK(bytes_of(exported.temporary.path / "job").size() == 1);
  fs::create_directories(exported.temporary.path / "empty");
  exported.write(exported.temporary.path / "empty", {});
}

TEST_CASE("a folder with another export, finished or begun, is refused with the difference") {
  const Exported exported;
  exported.write(exported.out, {.shard_mb = 2});
  CHECK_THROWS_WITH(exported.write(exported.out, {.shard_mb = 3}),
                    Catch::Contains("is of another export (shard_mb: 2, not 3)"));
  CHECK_THROWS_WITH(exported.write(exported.out, {.target = ExportTarget::kitti}),
                    Catch::Contains("format: \"webdataset\", not \"kitti\""));
  const fs::path begun = exported.temporary.path / "begun";
  CHECK_THROWS_AS(exported.write(begun, {.target = ExportTarget::kitti}, stop_after(1)), Stopped);
  CHECK_THROWS_WITH(exported.write(begun, {}), Catch::Contains("not \"webdataset\""));
  edit_column(exported.root / exported.plan.groups[0].folder / "frames.csv", "street",
              [](const std::string& street) { return street + "x"; });
  CHECK_THROWS_WITH(exported.write(begun, {.target = ExportTarget::kitti}),
                    Catch::Contains("dataset_sha256"));
}

TEST_CASE("two processes do not write one export at once") {
  const Exported exported;
  CHECK_THROWS_AS(exported.write(exported.out, {},
                                 [&](std::int64_t, const std::string&) {
                                   CHECK_THROWS_AS(exported.write(exported.out, {}), HeldByAnother);
                                   throw Stopped{};
                                 }),
                  Stopped);
}

TEST_CASE("unfinished and damaged datasets are refused in one line, and nothing is written") {
  const Exported exported;
  const fs::path& root = exported.root;
  const auto refuses = [&](const std::string& expected) {
    CHECK_THROWS_WITH(read_export_source(root), Catch::Contains(expected));
  };
  const DatasetImage image = read_dataset(root).images.front();
  const fs::path frames = root / image.file.parent_path() / "frames.csv";
  const std::string good = read_file(frames), list = read_file(root / "splits/train.txt");

  write_file(frames, good.substr(0, good.size() / 2));
  refuses("frames.csv");
  write_file(frames, good.substr(0, good.find('\n') + 1));
  refuses("is not in frames.csv");
  write_file(frames, good);
  write_file(root / "splits/train.txt", list + list);
  refuses("stands in the split lists twice");
  write_file(root / "splits/train.txt", list);
  read_export_source(root);
  fs::rename(root / "dataset.json", root / "away.json");
  refuses("dataset.json: is missing");
  write_file(root / ".cps/job.json", std::string("{}"));
  refuses("it is not finished; run cps generate again");
}

TEST_CASE("an image that is not the one in frames.csv never reaches a tar") {
  const Exported exported;
  const fs::path image = read_dataset(exported.root).images.front().file;
  std::string bytes = read_file(exported.root / image);
  bytes[bytes.size() / 2] ^= 1;
  write_file(exported.root / image, bytes);
  CHECK_THROWS_WITH(exported.write(exported.out, {}),
                    Catch::Contains(image.string()) && Catch::Contains("hash is not that in frames.csv"));
  for (const auto& [name, content] : bytes_of(exported.out)) CHECK_THAT(name, Catch::StartsWith(".cps"));
  fs::remove(exported.root / image);
  CHECK_THROWS_WITH(exported.write(exported.temporary.path / "k", {.target = ExportTarget::kitti}),
                    Catch::Contains(image.string() + ": cannot be read"));
}

TEST_CASE("a dense label that is not the one in frames.csv never reaches an export") {
  const Labelled exported;
  const fs::path depth = dense_file(read_dataset(exported.root).images.front().file, DenseLabel::depth);
  std::string bytes = read_file(exported.root / depth);
  bytes[bytes.size() / 2] ^= 1;
  write_file(exported.root / depth, bytes);
  const auto refuses = [&](const ExportOptions& options, const std::string& expected) {
    CHECK_THROWS_WITH(exported.write(exported.out, options), Catch::Contains(depth.string() + expected));
    CHECK_FALSE(fs::exists(exported.out / "export.json"));
    for (const auto& [name, content] : bytes_of(exported.out))
      CHECK_FALSE((name.ends_with(".tar") || name.ends_with(".exr")));
    fs::remove_all(exported.out);
  };
  const ExportOptions copied{.target = ExportTarget::huggingface, .copy = true};
  refuses({}, ": its hash is not that in frames.csv");
  refuses(copied, ": its hash is not that in frames.csv");
  fs::remove(exported.root / depth);
  refuses({}, ": cannot be read");
  refuses(copied, ": cannot be read");
}

TEST_CASE("folders that do not have the same dense labels are refused") {
  const Labelled exported;
  const fs::path frames = exported.root / exported.plan.groups.back().folder / "frames.csv";
  CsvTable table = read_csv(frames);
  const std::size_t column = table.column("depth_sha256");
  table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(column));
  for (std::vector<std::string>& row : table.rows)
    row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  write_csv(table);
  CHECK_THROWS_WITH(read_export_source(exported.root),
                    Catch::Contains("has not the dense labels of other images"));
}

TEST_CASE("COLMAP, nerfstudio and KITTI get the images and no dense labels") {
  const Labelled exported;
  for (ExportTarget target : {ExportTarget::colmap, ExportTarget::nerfstudio, ExportTarget::kitti}) {
    const fs::path out = exported.temporary.path / to_string(target);
    exported.write(out, {.target = target});
    CHECK(images_below(out) == read_dataset(exported.root).images.size());
    for (const auto& [name, content] : bytes_of(out)) CHECK_FALSE(name.ends_with(".exr"));
  }
}

TEST_CASE("a dataset without poses goes where none are needed") {
  const Exported exported;
  fs::remove(exported.root / "dataset.json");  // what cps relens makes: no description, no frames.csv
  for (const PlannedGroup& group : exported.plan.groups)
    fs::remove(exported.root / group.folder / "frames.csv");
  for (ExportTarget target : {ExportTarget::colmap, ExportTarget::nerfstudio})
    CHECK_THROWS_WITH(exported.write(exported.out, {.target = target}),
                      Catch::Contains("has no frames.csv, so no poses"));
  CHECK_FALSE(fs::exists(exported.out));
  for (ExportTarget target : {ExportTarget::webdataset, ExportTarget::huggingface, ExportTarget::kitti})
    CHECK_NOTHROW(exported.write(exported.temporary.path / to_string(target), {.target = target}));
}
