#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("SHA-256 agrees with the published test vectors (FIPS 180-4)") {
  CHECK(sha256(std::string("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256(std::string()) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("a file is written completely or not at all") {
  const TemporaryFolder temporary;
  const auto& folder = temporary.path;
  write_file(folder / "a" / "b.txt", std::string("hello"));
  CHECK(read_file(folder / "a" / "b.txt") == "hello");
  write_file(folder / "blocked", std::string("a file, not a folder"));
  CHECK_THROWS_WITH(write_file(folder / "blocked" / "c.txt", std::string("x")),
                    Catch::Contains("blocked/c.txt"));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    files += entry.is_regular_file();
  CHECK(files == 2);
  CHECK_THROWS_WITH(read_file(folder / "none"), Catch::Contains("none"));
  write_file(folder / "bad.json", std::string("{\"a\": }"));
  CHECK_THROWS_WITH(read_json(folder / "bad.json"),
                    Catch::Contains("bad.json") && Catch::Contains("not JSON"));
}

TEST_CASE("only temporary files of a killed writer are removed") {
  const TemporaryFolder temporary;
  const auto& folder = temporary.path;
  // Names that people and other programs choose.
  const std::vector<std::string> others = {
      "notes.tmp",          "notes.tmp.txt",    "x.tmpl",      "a.0123abcd-1.tmp.png", ".0123abcd-1.tmp",
      "a.0123abcg-1.tmp",   "a.0123abcd-.tmp",  "a.123-1.tmp", "0123abcd-1.tmp",       "a.0123abcd1.tmp",
      "a.0123abcd-1-1.tmp", "a.00123abcd-1.tmp"};
  for (const std::string& name : others) write_file(folder / name, std::string("mine"));
  std::filesystem::create_directories(folder / "b.0123abcd-1.tmp" / "full");
  // A writer that is killed between writing and renaming, as it finds its own temporary name.
  std::filesystem::path left;
  try {
    write_by_rename(folder / "image.png", [&](const std::filesystem::path& name) {
      left = name;
      throw std::runtime_error("killed");
    });
  } catch (const std::runtime_error&) {
  }
  for (const std::filesystem::path& name : {left, folder / "a.png.0123abcd-1f.tmp"})
    write_file(name, std::string("half"));
  remove_temporaries(folder);
  CHECK_FALSE(std::filesystem::exists(left));
  CHECK_FALSE(std::filesystem::exists(folder / "a.png.0123abcd-1f.tmp"));
  for (const std::string& name : others) {
    INFO(name);
    CHECK(std::filesystem::exists(folder / name));
  }
  CHECK(std::filesystem::exists(folder / "b.0123abcd-1.tmp" / "full"));
}
