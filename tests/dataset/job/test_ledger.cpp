#include <catch2/catch.hpp>

#include "dataset/job/ledger.h"
#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("a ledger keeps the times of every run, by shard and in their order") {
  const TemporaryFolder folder;
  CHECK(read_ledger(folder.path).empty());
  const RunTimes stopped{
      .views = 3,
      .images = 12,
      .is_interrupted = true,
      .threads = 2,
      .wall_s = 1.5,
      .cpu_s = 2.75,
      .cpu = {.render_s = 2, .warp_s = 0.1, .develop_s = 0.2, .encode_s = 0.3, .write_s = 0.05}};
  RunTimes rest = stopped;
  rest.views = 4;
  rest.is_interrupted = false;
  enter_in_ledger(folder.path, {1, 2}, stopped);
  enter_in_ledger(folder.path, {0, 2}, rest);
  enter_in_ledger(folder.path, {1, 2}, rest);
  const std::vector<LedgerEntry> entries = read_ledger(folder.path);
  REQUIRE(entries.size() == 3);
  CHECK(entries[0].shard == Shard{0, 2});
  CHECK(entries[1].shard == Shard{1, 2});
  const RunTimes& read = entries[1].times;
  CHECK(read.views == 3);
  CHECK(read.images == 12);
  CHECK(read.is_interrupted);
  CHECK(read.threads == 2);
  CHECK(read.wall_s == 1.5);
  CHECK(read.cpu_s == 2.75);
  CHECK(read.cpu.warp_s == 0.1);
  CHECK(read.cpu.sum_s() == Approx(2.65));
  CHECK(entries[2].times.views == 4);
  CHECK_FALSE(entries[2].times.is_interrupted);
}

TEST_CASE("a damaged ledger is named") {
  const TemporaryFolder folder;
  const auto file = folder.path / ".cps" / "times_0_of_1.jsonl";
  write_file(file, std::string("{\"views\":1}\n"));
  CHECK_THROWS_WITH(read_ledger(folder.path), Catch::EndsWith("times_0_of_1.jsonl: images: is missing"));
  write_file(file, std::string("views\n"));
  CHECK_THROWS_WITH(read_ledger(folder.path), Catch::Contains("times_0_of_1.jsonl: is not JSON"));
  write_file(folder.path / ".cps" / "times_0_of_1.jsonl.bak", std::string("no ledger"));
  std::filesystem::remove(file);
  CHECK(read_ledger(folder.path).empty());
}
