#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "files/files.h"
#include "tests/apps/manual/programs.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// What the build writes for sources in that folder.
std::string written_commit(const fs::path& source, const fs::path& file) {
  output_of("cmake -DSOURCE=" + source.string() + " -DFILE=" + file.string() +
            " -P " CPS_SOURCE "/cmake/find_commit.cmake");
  const std::string text = read_file(file);
  std::smatch match;
  REQUIRE(std::regex_search(text, match, std::regex("source_commit = \"([^\"]*)\";")));
  return match[1];
}

}  // namespace

TEST_CASE("--version names version and commit") {
  for (const std::string& program : built_programs()) {
    const std::string text = output_of(program + " --version");
    INFO(text);
    CHECK(std::regex_match(text,
                           std::regex(fs::path(program).filename().string() +
                                      R"( \d+\.\d+\.\d+ \(commit ([0-9a-f]{10,}(-dirty)?|unknown)\)\n)")));
  }
}

TEST_CASE("the commit is that of the checkout, marked if files differ from it, and unknown without one") {
  const TemporaryFolder folder;
  const fs::path source = folder.path / "sources", file = folder.path / "commit.cpp";
  fs::create_directories(source / "part");
  write_file(source / "a.txt", std::string("a"));
  CHECK(written_commit(source, file) == "unknown");

  const std::string git = "git -C " + source.string() + " -c user.name=a -c user.email=a@b.c ";
  output_of(git + "init -q && " + git + "add a.txt && " + git + "commit -q -m first && " + git + "tag v1");
  std::string head = output_of(git + "rev-parse --short=10 HEAD");
  head.pop_back();
  CHECK(written_commit(source, file) == head);
  CHECK(written_commit(source / "part", file) == "unknown");  // of another repository
  CHECK(written_commit(source, file) == head);

  const fs::file_time_type before = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(file, before);
  CHECK(written_commit(source, file) == head);
  CHECK(fs::last_write_time(file) == before);  // the same commit compiles nothing anew
  write_file(source / "a.txt", std::string("b"));
  CHECK(written_commit(source, file) == head + "-dirty");
  CHECK(fs::last_write_time(file) != before);
}
