#include <catch2/catch.hpp>

#include "dataset/verify/kept_results.h"
#include "files/files.h"
#include "tests/temporary_folder.h"

using namespace cps;

TEST_CASE("what verify found is read back, infinities too") {
  const TemporaryFolder folder;
  CHECK_FALSE(kept_verification(folder.path));
  CHECK(description_sha256(folder.path).empty());
  write_file(folder.path / "dataset.json", std::string("{}\n"));
  VerifySummary summary{.groups = 2,
                        .images = 30,
                        .masters = 4,
                        .max_roundtrip_px = INFINITY,
                        .min_rim_margin_px = -0.5,
                        .faults = {}};
  for (int i = 0; i < 150; ++i) summary.faults.push_back("fault " + std::to_string(i));
  keep_verification(folder.path, summary, true);
  const auto kept = kept_verification(folder.path);
  REQUIRE(kept);
  CHECK(kept->dataset_sha256 == sha256(std::string("{}\n")));
  CHECK(kept->groups == 2);
  CHECK(kept->images == 30);
  CHECK(kept->masters == 4);
  CHECK(std::isinf(kept->max_roundtrip_px));
  CHECK(kept->min_rim_margin_px == -0.5);
  CHECK(kept->is_planned_again);
  CHECK(kept->faults == 150);
  REQUIRE(kept->first_faults.size() == 100);
  CHECK(kept->first_faults[99] == "fault 99");
}

TEST_CASE("what was rendered again is read back") {
  const TemporaryFolder folder;
  CHECK_FALSE(kept_rerender(folder.path));
  keep_rerender(folder.path, {.samples = 16,
                              .max_shift_px = 0.1,
                              .max_block_rms_px = 0.2,
                              .images = {{.file = "set/leaf/000001.png",
                                          .registration = {.shift_x_px = 0.25,
                                                           .shift_y_px = -0.5,
                                                           .shift_noise_px = 0.01,
                                                           .blocks = 12,
                                                           .block_rms_px = 0.03,
                                                           .worst_block_px = 0.07,
                                                           .correlation = 0.99,
                                                           .psnr_db = INFINITY},
                                          .fault = "lies off"}}});
  const auto kept = kept_rerender(folder.path);
  REQUIRE(kept);
  CHECK(kept->samples == 16);
  CHECK(kept->max_block_rms_px == 0.2);
  REQUIRE(kept->images.size() == 1);
  const Registration& found = kept->images[0].registration;
  CHECK(found.shift_x_px == 0.25);
  CHECK(found.shift_y_px == -0.5);
  CHECK(found.blocks == 12);
  CHECK(found.worst_block_px == 0.07);
  CHECK(std::isinf(found.psnr_db));
  CHECK(kept->images[0].fault == "lies off");
  write_file(folder.path / ".cps" / "rerender.json", std::string("{\"samples\":-1}"));
  CHECK_THROWS_WITH(kept_rerender(folder.path),
                    Catch::Contains("rerender.json: samples: must be a whole number"));
}
