#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "dataset/job/journal.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

ViewRecord record_of(std::int64_t view, const fs::path& root) {
  const std::string file = "set/leaf/" + std::to_string(view) + ".png";
  write_file(root / file, std::string("picture"));
  return {.view = view,
          .exposure = 0.1 + 0.2,
          .images = {{.file = file,
                      .sensor = {.exposure_bias_ev = 0.1, .full_well_e = 1234.5, .read_noise_e = 3},
                      .bytes = 7,
                      .sha256 = "a",
                      .pixels_sha256 = "b"}}};
}

fs::path file_of(const fs::path& root, const char* shard = "0_of_1") {
  return root / ".cps" / ("journal_" + std::string(shard) + ".jsonl");
}

void write_journal(const fs::path& root, const std::vector<std::int64_t>& views, const Shard& shard = {}) {
  Journal journal(root, shard);
  for (std::int64_t v : views) journal.append(record_of(v, root));
}

}  // namespace

TEST_CASE("journalled views are found when the job is resumed") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  CHECK(read_journals(root).views.empty());
  write_journal(root, {0, 1, 5});
  write_journal(root, {7});
  const JournalLines lines = read_journals(root);
  REQUIRE(lines.views.size() == 4);
  const ViewRecord& five = lines.views.at(5);
  CHECK(five.exposure == 0.1 + 0.2);
  CHECK(five.images[0].sensor.full_well_e == 1234.5);
  CHECK(five.images[0].bytes == 7);
  CHECK(five.images[0].pixels_sha256 == "b");
  CHECK(lines.unreadable == 0);
}

TEST_CASE("views made under any number of shards count as made") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_journal(root, {0, 1}, {0, 2});
  write_journal(root, {1, 2}, {1, 3});
  write_journal(root, {9}, {0, 1});
  CHECK(read_journals(root).views.size() == 4);
  CHECK(journalled_shard_counts(root) == std::vector<std::int64_t>{1, 2, 3});
}

TEST_CASE("a line cut short at any byte loses that view only, and the journal can be continued") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_journal(root, {0, 1});
  const std::string whole = read_file(file_of(root));
  const std::size_t first = whole.find('\n') + 1;
  for (std::size_t size = first; size < whole.size(); ++size) {
    write_file(file_of(root), whole.substr(0, size));
    CHECK(read_journals(root).views.size() == 1);
    CHECK(read_journals(root).unreadable == 0);  // another process may be writing it
    write_journal(root, {1});
    CHECK(read_file(file_of(root)) == whole);
  }
}

TEST_CASE("a line in which any one byte changed is rejected as damaged") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_journal(root, {0, 1, 2});
  const std::string whole = read_file(file_of(root));
  const std::size_t begin = whole.find('\n') + 1, end = whole.find('\n', begin);
  for (std::size_t i = begin; i < end; ++i) {
    std::string damaged = whole;
    damaged[i] = damaged[i] == '1' ? '2' : '1';
    write_file(file_of(root), damaged);
    const JournalLines lines = read_journals(root);
    CHECK(lines.views.size() == 2);
    CHECK(lines.unreadable == 1);
  }
}

TEST_CASE("a view counts as not made when an image is missing or cut short") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  const ViewRecord record = record_of(2, root);
  CHECK(has_its_images(root, record));
  fs::resize_file(root / "set/leaf/2.png", 3);
  CHECK_FALSE(has_its_images(root, record));
  fs::remove(root / "set/leaf/2.png");
  CHECK_FALSE(has_its_images(root, record));
}

TEST_CASE("only one process at a time opens a shard's journal; other shards are not affected") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  {
    const Journal journal(root, {1, 4});
    CHECK_THROWS_WITH(Journal(root, Shard{1, 4}),
                      Catch::Contains("shard 1/4 is being made by another process"));
    const Journal other(root, {2, 4});
  }
  const Journal again(root, {1, 4});
}

TEST_CASE("a journal that cannot be written throws and keeps its whole lines") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  const ViewRecord record = record_of(1, root);
  write_journal(root, {0});
  const std::string whole = read_file(file_of(root));
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  Journal journal(root, {});
  const rlimit small{whole.size() + 20, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_THROWS_WITH(journal.append(record), Catch::Contains("journal_0_of_1.jsonl: cannot be written"));
  setrlimit(RLIMIT_FSIZE, &before);
  CHECK(read_file(file_of(root)) == whole);
  journal.append(record);
  CHECK(read_journals(root).views.size() == 2);
}
