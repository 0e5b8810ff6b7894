#include <catch2/catch.hpp>

#include "dataset/journal.h"
#include "small_dataset.h"

using namespace cps;

namespace {

ViewRecord record_of(std::int64_t view, const std::filesystem::path& root) {
  const std::string file = "set/leaf/" + std::to_string(view) + ".png";
  write_file(root / file, std::string("picture"));
  return {.view = view,
          .exposure = 0.1 + 0.2,
          .images = {{.file = file,
                      .sensor = {.exposure_bias_ev = 0.1, .full_well_e = 1234.5, .read_noise_e = 3},
                      .sha256 = "a",
                      .pixels_sha256 = "b"}}};
}

}  // namespace

TEST_CASE("what was journalled is there when the job is taken up again") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  {
    Journal journal(root, {"job", "seed = 0\n"});
    for (int v : {0, 1, 5}) journal.append(record_of(v, root));
  }
  const Journal again(root, {"job", "seed = 0\n"});
  REQUIRE(again.finished().size() == 3);
  const ViewRecord& five = again.finished().at(5);
  CHECK(five.exposure == 0.1 + 0.2);
  CHECK(five.images[0].sensor.full_well_e == 1234.5);
  CHECK(five.images[0].pixels_sha256 == "b");
  CHECK(again.dropped_lines() == 0);
}

TEST_CASE("a line cut at any byte costs that view only, and the journal goes on cleanly") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  {
    Journal journal(root, {"job", ""});
    journal.append(record_of(0, root));
    journal.append(record_of(1, root));
  }
  const std::filesystem::path file = root / ".cps" / "journal.jsonl";
  const std::string whole = read_file(file);
  const std::size_t first = whole.find('\n') + 1;
  for (std::size_t size = first; size < whole.size(); ++size) {
    write_file(file, whole.substr(0, size));
    {
      Journal journal(root, {"job", ""});
      CHECK(journal.finished().size() == 1);
      journal.append(record_of(1, root));
    }
    CHECK(read_file(file) == whole);
  }
}

TEST_CASE("a damaged line and a vanished picture cost their views only") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  {
    Journal journal(root, {"job", ""});
    for (int v : {0, 1, 2}) journal.append(record_of(v, root));
  }
  const std::filesystem::path file = root / ".cps" / "journal.jsonl";
  std::string text = read_file(file);
  text[text.find('\n') + 5] = '\x01';
  write_file(file, text);
  std::filesystem::remove(root / "set/leaf/2.png");
  const Journal again(root, {"job", ""});
  CHECK(again.finished().size() == 1);
  CHECK(again.finished().contains(0));
  CHECK(again.dropped_lines() == 1);
}

TEST_CASE("another recipe in the same folder is refused, with the difference named") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  { const Journal journal(root, {"job", "seed = 0\nviews = 3\n"}); }
  CHECK_THROWS_WITH(Journal(root, Job{"other", "seed = 0\nviews = 4\n"}),
                    Catch::Contains("\"views = 3\" became \"views = 4\""));
}
