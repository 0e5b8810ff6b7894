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
std::vector<Member> members_of_part(const fs::path& out, const std::string& part) {
  std::vector<Member> all;
  const nlohmann::json index = read_json(out / (part + "-index.json"));
  for (const nlohmann::json& shard : index.at("shardlist")) {
    const std::string tar = read_file(out / shard.at("url").get<std::string>());
    CHECK(shard.at("sha256") == sha256(tar));
    CHECK(shard.at("filesize") == tar.size());
    const std::vector<Member> members = members_of(tar);
    CHECK(members.size() == 2 * shard.at("nsamples").get<std::size_t>());
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
