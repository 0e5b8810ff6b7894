#include <catch2/catch.hpp>

#include "dataset/job/job.h"
#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

Job job_of(const std::string& recipe) {
  return {.recipe = recipe,
          .rig = "[front]\n",
          .drive = "scale = 0\n",
          .scenes = "sha256 of a.glb = 12\n",
          .generator = "cps 1",
          .folder = "/home"};
}

}  // namespace

TEST_CASE("a job reads back from its folder") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  CHECK_FALSE(has_job(root));
  CHECK_THROWS_WITH(read_job(root), Catch::Contains("no cps generate was begun"));
  const Job job = job_of("seed = 0\nviews = 3\n");
  begin_job(root, job);
  begin_job(root, job);
  const Job read = read_job(root);
  CHECK(read.recipe == job.recipe);
  CHECK(read.rig == job.rig);
  CHECK(read.drive == job.drive);
  CHECK(read.scenes == job.scenes);
  CHECK(read.generator == job.generator);
  CHECK(read.folder == job.folder);
}

TEST_CASE("a different job in the same folder is refused with the first difference") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  begin_job(root, job_of("seed = 0\nviews = 3\n"));
  CHECK_THROWS_WITH(begin_job(root, job_of("seed = 0\nviews = 4\n")),
                    Catch::Contains("\"views = 3\" became \"views = 4\""));
  CHECK_THROWS_WITH(begin_job(root, job_of("seed = 0\nviews = 3\nlenses = 2\n")),
                    Catch::Contains("\"\" became \"lenses = 2\""));
  Job other = job_of("seed = 0\nviews = 3\n");
  other.folder = "/elsewhere";
  CHECK_NOTHROW(require_same_job(root, other));
  other.scenes = "";  // not known yet
  CHECK_NOTHROW(require_same_job(root, other));
  other.scenes = "sha256 of a.glb = 13\n";
  CHECK_THROWS_WITH(require_same_job(root, other), Catch::Contains("sha256 of a.glb = 13"));
  other.generator = "cps 2";
  CHECK_THROWS_WITH(require_same_job(root, other), Catch::Contains("cps 2"));
}

TEST_CASE("a job comes to know its scenes as processes use them") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  const auto job_that_knows = [](const std::string& a, const std::string& b) {
    Job job = job_of("seed = 0\n");
    job.scenes = "sha256 of a.glb = " + a + "\nsha256 of b.glb = " + b + "\n";
    return job;
  };
  begin_job(root, job_that_knows("", ""));
  begin_job(root, job_that_knows("", "34"));
  CHECK(read_job(root).scenes == job_that_knows("", "34").scenes);
  begin_job(root, job_that_knows("12", ""));
  CHECK(read_job(root).scenes == job_that_knows("12", "34").scenes);
  begin_job(root, job_that_knows("", ""));
  CHECK(read_job(root).scenes == job_that_knows("12", "34").scenes);
  CHECK_THROWS_WITH(begin_job(root, job_that_knows("", "35")),
                    Catch::Contains("\"sha256 of b.glb = 34\" became \"sha256 of b.glb = 35\""));
  CHECK(read_job(root).scenes == job_that_knows("12", "34").scenes);
}

TEST_CASE("a damaged job file is refused by name") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  begin_job(root, job_of(""));
  write_file(root / ".cps" / "job.json", std::string("{\"recipe\": 3}"));
  CHECK_THROWS_WITH(read_job(root), Catch::Contains("job.json: recipe: must be text"));
}
