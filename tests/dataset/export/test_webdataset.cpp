#include <catch2/catch.hpp>

#include "tests/dataset/edit_csv.h"
#include "tests/dataset/export/exported.h"

using namespace cps;
namespace fs = std::filesystem;

/// tests/python/test_cps_dataset.py reads the tars with Python's tarfile. Here: labels, shards, what is kept.
namespace {

struct Member {
  std::string name, bytes;
};

/// The files of a ustar archive.
std::vector<Member> members_of(const std::string& tar) {
  std::vector<Member> members;
  for (std::size_t at = 0; at < tar.size() && tar[at] != '\0';) {
    const std::size_t bytes = std::stoul(tar.substr(at + 124, 11), nullptr, 8);
    members.push_back({tar.substr(at).c_str(), tar.substr(at + 512, bytes)});
    at += 512 + (bytes + 511) / 512 * 512;
  }
  return members;
}

/// The members of all shards of a part, in their order.
std::vector<Member> members_of_part(const fs::path& out, const std::string& part,
                                    std::size_t files_per_sample = 2) {
  std::vector<Member> all;
  const nlohmann::json index = read_json(out / (part + "-index.json"));
  for (const nlohmann::json& shard : index.at("shardlist")) {
    const std::string tar = read_file(out / shard.at("url").get<std::string>());
    CHECK(shard.at("sha256") == sha256(tar));
    CHECK(shard.at("filesize") == tar.size());
    const std::vector<Member> members = members_of(tar);
    CHECK(members.size() == files_per_sample * shard.at("nsamples").get<std::size_t>());
    all.insert(all.end(), members.begin(), members.end());
  }
  return all;
}

}  // namespace

TEST_CASE("tars hold the images of each list in its order, with what labels and frames.csv say") {
  const Exported exported(ExportTarget::webdataset);
  const Dataset dataset = read_dataset(exported.root);
  std::map<std::string, std::vector<Member>> members;
  std::map<std::string, std::size_t> next;
  for (const char* part : {"train", "val", "test"}) members[part] = members_of_part(exported.out, part);
  for (const DatasetImage& image : dataset.images) {
    INFO(image.file);
    const std::string part = to_string(image.part);
    REQUIRE(members[part].size() > next[part] + 1);
    const Member &stored = members[part][next[part]], &json = members[part][next[part] + 1];
    next[part] += 2;
    CHECK(stored.name.substr(0, 9) == json.name.substr(0, 9));
    CHECK(stored.bytes == read_file(exported.root / image.file));
    const nlohmann::json sample = nlohmann::json::parse(json.bytes);
    const nlohmann::json label =
        read_json(exported.root / dataset.groups[image.group].folder / "calibration.json");
    CHECK(sample.at("file") == image.file.string());
    CHECK(sample.at("group") == dataset.groups[image.group].folder.string());
    CHECK(sample.at("camera") == label["camera"]["name"]);
    for (const char* key : {"width", "height", "fov", "k1", "k2", "k3", "p1", "p2", "cx", "cy"})
      CHECK(sample.at(key) == label[key]);
    CHECK(sample.at("fx") == label["K"][0][0]);
    CHECK(sample.at("fy") == label["K"][1][1]);
    CHECK(sample.at("fov_true_d_deg") == label["fov_true_deg"]["d"]);

    const CsvTable frames = read_csv(exported.root / image.file.parent_path() / "frames.csv");
    std::size_t row = 0;
    while (frames.at(row, frames.column("file")).text() != image.file.filename()) ++row;
    for (const char* key : {"camera_x_m", "camera_y_m", "camera_z_m", "camera_qw", "camera_qx", "camera_qy",
                            "camera_qz", "condition"})
      CHECK(sample.at(key).get<double>() == frames.at(row, frames.column(key)).number());
    for (const char* key : {"street", "sha256"})
      CHECK(sample.at(key) == frames.at(row, frames.column(key)).text());
  }
  for (const char* part : {"train", "val", "test"}) CHECK(next[part] == members[part].size());
}

TEST_CASE("a finished shard is kept if it is what was written, and made again if not") {
  const Exported exported;
  struct Stopped {};
  const auto stop = [](std::int64_t, const std::string&) { throw Stopped{}; };
  const fs::path shard = exported.out / "train-000000.tar";
  CHECK_THROWS_AS(exported.write(exported.out, {}, stop), Stopped);
  const std::string good = read_file(shard);
  const auto age = [&] { return fs::last_write_time(shard); };
  const auto old = age() - std::chrono::hours(1);
  fs::last_write_time(shard, old);
  CHECK_THROWS_AS(exported.write(exported.out, {}, stop), Stopped);
  CHECK(age() == old);

  std::string bad = good;
  bad[600] ^= 1;
  write_file(shard, bad);
  fs::last_write_time(shard, old);
  CHECK_THROWS_AS(exported.write(exported.out, {}, stop), Stopped);
  CHECK(read_file(shard) == good);

  write_file(exported.out / ".cps" / "train-000000.tar.json", std::string("{\"samples\": -1"));
  exported.write(exported.out, {});
  CHECK(read_file(shard) == good);
}

TEST_CASE("a sample has its dense labels between image and label, and they count for the size of a tar") {
  const Labelled exported;
  constexpr std::size_t files_per_sample = 2 + all_dense_labels.size();
  exported.write(exported.out, {.shard_mb = 1});
  std::map<std::string, std::vector<Member>> members;
  std::map<std::string, std::size_t> next;
  for (const char* part : {"train", "val", "test"})
    members[part] = members_of_part(exported.out, part, files_per_sample);
  for (const DatasetImage& image : read_dataset(exported.root).images) {
    INFO(image.file);
    const std::string part = to_string(image.part);
    REQUIRE(members[part].size() >= next[part] + files_per_sample);
    const auto at = [&](std::size_t i) { return members[part][next[part] + i]; };
    const std::string key = at(0).name.substr(0, 9);
    CHECK(at(0).name == key + ".png");
    for (std::size_t l = 0; l < all_dense_labels.size(); ++l) {
      const fs::path file = dense_file(image.file, all_dense_labels[l]);
      CHECK(at(1 + l).name == key + "." + to_string(all_dense_labels[l]) + file.extension().string());
      CHECK(at(1 + l).bytes == read_file(exported.root / file));
    }
    CHECK(at(files_per_sample - 1).name == key + ".json");
    next[part] += files_per_sample;
  }

  // No tar is larger than it may be, and none is so small that the next one's first sample had fitted.
  constexpr std::size_t most_bytes = 1'000'000;
  std::size_t shards = 0;
  for (const std::string part : {"train", "val", "test"}) {
    std::size_t before = 0;
    const nlohmann::json index = read_json(exported.out / (part + "-index.json"));
    for (const nlohmann::json& shard : index.at("shardlist")) {
      const std::vector<Member> files =
          members_of(read_file(exported.out / shard.at("url").get<std::string>()));
      std::size_t first_sample = 0;
      for (std::size_t i = 0; i < files_per_sample; ++i)
        first_sample += 512 + (files[i].bytes.size() + 511) / 512 * 512;
      CHECK(shard.at("filesize") <= most_bytes);
      if (before > 0) CHECK(before + first_sample > most_bytes);
      before = shard.at("filesize");
      ++shards;
    }
  }
  CHECK(shards > 3);
}

TEST_CASE("classes.json tells what the classes of each condition's scene are") {
  const Labelled exported(ExportTarget::webdataset);
  const nlohmann::json classes = read_json(exported.out / "classes.json"),
                       description = read_json(exported.root / "dataset.json");
  CHECK(classes.at("conditions").size() == description.at("conditions").size());
  for (const nlohmann::json& scene : classes.at("conditions"))
    CHECK(classes.at("scenes").at(scene.get<std::string>()) == some_classes());
  const Exported without(ExportTarget::webdataset);
  CHECK_FALSE(fs::exists(without.out / "classes.json"));
}
