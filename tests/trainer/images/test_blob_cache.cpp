#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <mutex>
#include <set>

#include "files/file_lock.h"
#include "files/files.h"
#include "tests/temporary_folder.h"
#include "trainer/images/blob_cache.h"

using namespace cps;

namespace {

const std::vector<std::size_t> sizes = {5, 4096, 0, 77, 100000, 1};

/// Fills a blob with bytes that depend on its number alone, and records which blobs it was asked for.
struct Maker {
  std::set<std::size_t> broken = {};
  std::set<std::size_t> made = {};
  std::mutex mutex = {};

  BlobCache load(const std::filesystem::path& file, const std::string& key = "key") {
    made.clear();
    return load_blob_cache(
        key, sizes,
        [&](std::size_t i, std::span<std::uint8_t> bytes) {
          const std::lock_guard lock(mutex);
          if (broken.contains(i)) throw std::runtime_error("blob " + std::to_string(i) + " is broken");
          made.insert(i);
          for (std::size_t k = 0; k < bytes.size(); ++k)
            bytes[k] = static_cast<std::uint8_t>(31 * i + 7 * k + 1);
        },
        file);
  }
};

bool is_right(const BlobCache& cache) {
  if (cache.blobs.size() != sizes.size()) return false;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (cache.blobs[i].size() != sizes[i]) return false;
    for (std::size_t k = 0; k < sizes[i]; ++k)
      if (cache.blobs[i][k] != static_cast<std::uint8_t>(31 * i + 7 * k + 1)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("blobs are made once, and found again until their key changes") {
  const TemporaryFolder folder;
  const auto file = folder.path / "x.cache";
  Maker maker;
  CHECK(is_right(maker.load(file)));
  CHECK(maker.made.size() == sizes.size());
  const BlobCache again = maker.load(file);
  CHECK(is_right(again));
  CHECK(again.made == 0);
  CHECK(maker.made.empty());
  CHECK(is_right(maker.load(file, "another key")));
  CHECK(maker.made.size() == sizes.size());
  CHECK_FALSE(std::filesystem::exists(file.string() + ".partial"));
  CHECK(is_right(maker.load({})));  // in memory
}

TEST_CASE("making blobs continues where it stopped") {
  const TemporaryFolder folder;
  const auto file = folder.path / "x.cache";
  Maker maker;
  maker.broken = {1, 4};
  CHECK_THROWS_WITH(maker.load(file), "blob 1 is broken (and 1 more)");
  CHECK_FALSE(std::filesystem::exists(file));
  maker.broken.clear();
  CHECK(is_right(maker.load(file)));
  CHECK(maker.made == std::set<std::size_t>{1, 4});
}

TEST_CASE("a damaged blob is made again, and it alone") {
  const TemporaryFolder folder;
  const auto file = folder.path / "x.cache";
  Maker maker;
  maker.load(file);
  std::string bytes = read_file(file);
  bytes[bytes.size() - 1 - 50000] ^= 1;  // in blob 4
  write_file(file, bytes);
  CHECK(is_right(maker.load(file)));
  CHECK(maker.made == std::set<std::size_t>{4});
  write_file(file, bytes.substr(0, bytes.size() - 1));  // cut short: all
  CHECK(is_right(maker.load(file)));
  CHECK(maker.made.size() == sizes.size());
}

TEST_CASE("a cache's bytes do not depend on threads") {
  const TemporaryFolder folder;
  Maker maker;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    maker.load(folder.path / "one");
  }
  maker.load(folder.path / "many");
  CHECK(read_file(folder.path / "one") == read_file(folder.path / "many"));
}

TEST_CASE("a cache that another process is writing, or that cannot be written, is refused in one line") {
  const TemporaryFolder folder;
  const auto file = folder.path / "x.cache";
  Maker maker;
  {
    const FileLock lock(file.string() + ".lock", FileLock::Kind::exclusive);
    CHECK_THROWS_AS(maker.load(file), HeldByAnother);
  }
  write_file(folder.path / "file", std::string("no folder"));
  CHECK_THROWS_WITH(maker.load(folder.path / "file/x.cache"), Catch::Contains("x.cache"));
}
