#include <catch2/catch.hpp>

#include "dataset/job/job.h"
#include "dataset/report/page.h"
#include "dataset/verify/kept_results.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

int count_of(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// A plan whose texts would be markup if they were not escaped.
Plan awkward_plan() {
  Plan plan = small_plan();
  plan.recipe.name = "</title><script>alert(1)</script> & \"x\"";
  plan.scenes[0].file = "a<b>&\"c\".glb";
  plan.scenes[0].credits = "<i>Ann</i> & Bob";
  plan.scenes[0].import_warnings = {"material </script><b>\"x\"</b>"};
  plan.rig.cameras[0].name = "</script><!--";
  for (PlannedView& view : plan.views) view.street = "<u>" + view.street;
  return plan;
}

}  // namespace

TEST_CASE("a report holds the dataset's exact counts and labels, and needs no other file") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  write_small_dataset(temporary.path, plan);
  const std::string page = report_page(temporary.path);
  const auto images = std::to_string(image_count(plan)), groups = std::to_string(plan.groups.size());
  CHECK_THAT(page, Catch::StartsWith("<!doctype html>") && Catch::EndsWith("</html>\n"));
  CHECK_THAT(page, Catch::Contains("<b>" + images + "</b>images") &&
                       Catch::Contains("<b>" + groups + "</b>groups") &&
                       Catch::Contains("<b>" + std::to_string(plan.views.size()) + "</b>views rendered"));
  CHECK_THAT(page, Catch::Contains("<h3>64x36_hfov060</h3>") && Catch::Contains("<h3>64x36_hfov120</h3>"));
  CHECK_THAT(page, Catch::Contains("Not verified") && Catch::Contains("No times were kept"));
  CHECK_THAT(page, Catch::Contains("<tr><td>max_displacement<td>0.35"));
  for (const PlannedGroup& group : plan.groups) {
    if (group.lens_number == 0) continue;
    const Label label = group_label(plan, group);
    CHECK_THAT(page, Catch::Contains("{\"folder\":\"" + group.folder + "\""));
    CHECK_THAT(page, Catch::Contains("\"k1\":" + nlohmann::json(label.distortion.k1).dump()));
    CHECK_THAT(page, Catch::Contains("\"cy\":" + nlohmann::json(label.camera.cy).dump()));
  }
  for (const char* other : {"src=\"http", "href=\"http", "url(http", "@import", "<link"}) {
    INFO(other);
    CHECK(count_of(page, other) == 0);
  }
  CHECK(count_of(page, "<img src=\"data:image/jpeg;base64,") == count_of(page, "<img"));
}

TEST_CASE("a report of the same dataset has the same bytes, wherever it lies") {
  const TemporaryFolder a, b;
  write_small_dataset(a.path, small_plan());
  fs::copy(a.path, b.path / "copy", fs::copy_options::recursive);
  const std::string page = report_page(a.path);
  CHECK(report_page(a.path) == page);
  CHECK(report_page(b.path / "copy") == page);
}

TEST_CASE("texts of a dataset do not become markup or script of its report") {
  const TemporaryFolder temporary;
  write_small_dataset(temporary.path, awkward_plan());
  keep_verification(temporary.path, {.groups = 1, .images = 1, .faults = {"<h1>a & b</h1>"}}, false);
  const std::string page = report_page(temporary.path);
  CHECK_THAT(page, Catch::Contains(
                       "<h1>&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;x&quot;</h1>"));
  CHECK_THAT(page, Catch::Contains("a&lt;b&gt;&amp;&quot;c&quot;.glb") &&
                       Catch::Contains("&lt;i&gt;Ann&lt;/i&gt; &amp; Bob") &&
                       Catch::Contains("material &lt;/script&gt;&lt;b&gt;&quot;x&quot;&lt;/b&gt;") &&
                       Catch::Contains("&lt;h1&gt;a &amp; b&lt;/h1&gt;"));
  for (const char* markup : {"<script>alert", "<i>Ann", "<b>\"x\"", "<!--", "<h1>a", "<u>"}) {
    INFO(markup);
    CHECK(count_of(page, markup) == 0);
  }
  CHECK(count_of(page, "</script>") == 2);  // the lenses' JSON and the lens picker
}

TEST_CASE("options bound what a report shows") {
  const TemporaryFolder temporary;
  write_small_dataset(temporary.path, small_plan());
  const std::string few = report_page(temporary.path, {.thumbnails = 5, .columns = 2, .lenses = 3});
  CHECK(count_of(few, "<img") == 4);  // two rows of two
  CHECK(count_of(few, "<option ") == 3);
  CHECK(count_of(few, "{\"folder\":") == 3);
  CHECK(count_of(report_page(temporary.path, {.rows_per_set = 5, .columns = 1}), "<img") == 10);
  // Fewer rows than sets: of some sets.
  CHECK(count_of(report_page(temporary.path, {.thumbnails = 2, .columns = 2}), "<h3>64x36_hfov") == 1);
  CHECK(count_of(report_page(temporary.path, {.thumbnails = 1}), "<img") == 1);
  CHECK(count_of(report_page(temporary.path, {.thumbnails = 0}), "<img") == 0);

  CHECK(ReportOptions{}.fault() == "");
  CHECK(ReportOptions{.thumbnails = 401}.fault() == "thumbnails: must lie in [0, 400]");
  CHECK(ReportOptions{.rows_per_set = 0}.fault() == "rows: must lie in [1, 100]");
  CHECK(ReportOptions{.columns = 0}.fault() == "columns: must lie in [1, 20]");
  CHECK(ReportOptions{.thumbnail_width_px = 8}.fault() == "thumbnail-width: must lie in [32, 640]");
  CHECK(ReportOptions{.lenses = 0}.fault() == "lenses: must lie in [1, 2000]");
}

TEST_CASE("a report tells what verify found, and whether the dataset has changed since") {
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_small_dataset(root, small_plan());
  VerifySummary summary = verify_dataset(root);
  keep_verification(root, summary, true);
  CHECK_THAT(report_page(root), Catch::Contains("Verified: no faults.") &&
                                    Catch::Contains("compared with the recipe's plan, made again") &&
                                    !Catch::Contains("has changed since"));
  summary.faults = {"front/000001.png: is missing"};
  keep_verification(root, summary, false);
  keep_rerender(root,
                {.samples = 64,
                 .max_shift_px = 0.1,
                 .max_block_rms_px = 0.2,
                 .images = {{.file = "a.png", .registration = {.shift_x_px = 0.3, .shift_y_px = 0.4}},
                            {.file = "b.png", .registration = {.psnr_db = INFINITY}, .fault = "lies off"}}});
  write_file(root / "dataset.json", read_file(root / "dataset.json") + "\n");
  CHECK_THAT(report_page(root), Catch::Contains("Faults found: 1.") &&
                                    Catch::Contains("front/000001.png: is missing") &&
                                    Catch::Contains("has changed since it was verified") &&
                                    Catch::Contains("1 of 2 images rendered again at 64 samples") &&
                                    Catch::Contains("<td>0.500 ± 0.000") && Catch::Contains("<td>lies off"));
}

TEST_CASE("a set that cps relens made has a report without places, light and recipe") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_small_dataset(root, plan);
  fs::remove(root / "dataset.json");
  for (const PlannedGroup& group : plan.groups) fs::remove(root / group.folder / "frames.csv");
  CHECK_THAT(report_page(root), Catch::Contains("Made by cps relens") && Catch::Contains("id=\"lenses\"") &&
                                    !Catch::Contains("id=\"places\"") && !Catch::Contains("id=\"light\""));
}

TEST_CASE("a report is refused in one line where the dataset is not whole") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  CHECK_THROWS_WITH(report_page(root / "none"), Catch::Contains("is not a folder; name a dataset"));
  write_small_dataset(root, plan);
  const std::string description = read_file(root / "dataset.json");
  fs::remove(root / "dataset.json");
  CHECK_THROWS_WITH(report_page(root), Catch::Contains("dataset.json: is missing"));
  begin_job(root, {});
  CHECK_THROWS_WITH(report_page(root), Catch::Contains("is not finished; run cps generate again"));
  write_file(root / "dataset.json", description);
  const fs::path folder = root / plan.groups[0].folder;
  fs::rename(folder / "frames.csv", root / "frames.csv");
  CHECK_THROWS_WITH(report_page(root), Catch::Contains("frames.csv: cannot be read"));
  fs::rename(root / "frames.csv", folder / "frames.csv");
  fs::rename(folder / "000000.png", root / "000000.png");
  CHECK_THROWS_WITH(report_page(root), Catch::Contains("000000.png: cannot be decoded"));
  fs::rename(root / "000000.png", folder / "000000.png");
  write_file(root / ".cps" / "verify.json", std::string("{}"));
  CHECK_THROWS_WITH(report_page(root), Catch::EndsWith("verify.json: generator: is missing"));
}
