#include <catch2/catch.hpp>
#include <cmath>

#include "production/costs/bill.h"

using namespace cps;

namespace {

/// Two sizes at two H-FOVs: per size 10 and 20 places, 2 and 4 images a view, a rig of two cameras.
Recipe two_sizes() {
  Recipe recipe;
  recipe.sizes = {{100, 50}, {200, 100}};
  recipe.base_hfov_deg = {60, 90};
  recipe.views.values = {10, 20};
  recipe.lenses.values = {1, 3};
  recipe.undistorted = true;
  return recipe;
}

constexpr RecipeCounts counts{
    .conditions = 3, .scene_files = 2, .sets = 4, .groups = 20, .views = 2 * (2 * 10 + 2 * 20)};

Pilot two_conditions() {
  return {
      .render_cpu_s = {{1, 2, 3, 4}, {3, 2, 5, 4}},
      .full_size_ratio = 2,
      .image_costs = {{.cpu_s = 0.5, .bytes = 1000}, {.cpu_s = 2, .bytes = 4000}},
      .city_cpu_s = 10,
      .scene_bytes = 1e6,
      .start = {.group_cpu_s = 0.01, .scene_load_cpu_s = 5, .view_place_cpu_s = 0.1, .condition_cpu_s = 7},
      .peak_bytes = 1'000'000'000,
      .view_bytes = 100'000'000,
      .scene_memory_bytes = 500'000'000};
}

constexpr double hour_s = 3600;

}  // namespace

TEST_CASE("a bill extrapolates a pilot as reckoned by hand") {
  const Bill bill = bill_of(two_sizes(), counts, two_conditions(), {});
  // Views by set: 20 20 40 40. The conditions' renders: 2 · 340 s and 2 · 460 s.
  CHECK(bill.render_core_h == Approx(800 / hour_s));
  // Images by set: 40 40 160 160.
  CHECK(bill.images_core_h == Approx((80 * 0.5 + 320 * 2) / hour_s));
  CHECK(bill.image_bytes == Approx(80 * 1000 + 320 * 4000));
  CHECK(bill.scenes_core_h == Approx(2 * 10 / hour_s));
  CHECK(bill.scene_bytes == Approx(2e6));
  // 20 lenses, 2 scenes, 120 places, 3 conditions.
  CHECK(bill.start_core_h == Approx((0.2 + 10 + 12 + 21) / hour_s));
  CHECK(bill.core_h == Approx((800 + 680 + 20 + 43.2) / hour_s));
  // Deviation of 680 s and 920 s over √2; that of the views, √8000 s, is smaller.
  CHECK(bill.core_h_error == Approx(120 / hour_s));
  // Sets 0 and 2 differ between conditions: 2 and 6 s, 6 and 10 s.
  CHECK(bill.view_cpu_s_spread == Approx((std::sqrt(8.0) / 4 + std::sqrt(8.0) / 8) / 4));
  REQUIRE(bill.set_images_per_core_h.size() == 4);
  CHECK(bill.set_images_per_core_h[0] == Approx(hour_s / (4.0 / 2 + 0.5)));
  CHECK(bill.set_images_per_core_h[3] == Approx(hour_s / (8.0 / 4 + 2)));
}

TEST_CASE("where conditions agree, the standard error is that of the views") {
  Pilot pilot = two_conditions();
  pilot.render_cpu_s = {{1, 3, 2, 2}, {3, 1, 2, 2}};  // 160 s either way
  const Bill bill = bill_of(two_sizes(), counts, pilot, {});
  // Two sets of 20 views, 2 and 6 s: variance 8 s² each, over two measurements.
  CHECK(bill.core_h_error == Approx(std::sqrt(2 * 20 * 20 * 8 / 2.0) / hour_s));
}

TEST_CASE("cells of the light cache are counted as if every view computed its own") {
  Pilot pilot = two_conditions();
  const Bill traced = bill_of(two_sizes(), counts, pilot, {});
  CHECK_THAT(to_text(two_sizes(), traced, pilot, {}), !Catch::Contains("cells"));
  pilot.cells_cpu_s = 18;
  const Bill cached = bill_of(two_sizes(), counts, pilot, {});
  CHECK(cached.cells_core_h == Approx(18.0 * static_cast<double>(counts.views) / hour_s));
  CHECK(cached.core_h == Approx(traced.core_h + cached.cells_core_h));
  CHECK_THAT(to_text(two_sizes(), cached, pilot, {}), Catch::Contains("cells"));
}

TEST_CASE("every shard starts for itself, and finish plans once more") {
  const Bill four = bill_of(two_sizes(), counts, two_conditions(), {.shards = 4});
  // Lenses 5 times, scenes and conditions 3 times more among neighbours, scenes and places twice.
  CHECK(four.start_core_h == Approx((5 * 0.2 + (2 + 3 + 2) * 5 + 2 * 12 + (3 + 3) * 7) / hour_s));
  CHECK(four.core_h - four.start_core_h == Approx((800 + 680 + 20) / hour_s));
  // Of more shards than views the others have nothing to load.
  const Bill many = bill_of(two_sizes(), counts, two_conditions(), {.shards = 1000});
  CHECK(many.start_core_h == Approx((1001 * 0.2 + (2 + 119 + 2) * 5 + 2 * 12 + (3 + 119) * 7) / hour_s));
  const std::string text = to_text(two_sizes(), four, two_conditions(), {});
  CHECK_THAT(text, Catch::Contains("start-up") && Catch::Contains("4 shards"));
}

TEST_CASE("memory grows with the views in flight, and with a second scene where one is loaded ahead") {
  const auto peak_bytes = [](int conditions, int threads) {
    RecipeCounts of_recipe = counts;
    of_recipe.conditions = conditions;
    return bill_of(two_sizes(), of_recipe, two_conditions(), {.threads = threads}).peak_bytes;
  };
  CHECK(peak_bytes(3, 1) == 1'100'000'000);
  CHECK(peak_bytes(3, 2) == 1'600'000'000);
  CHECK(peak_bytes(3, 16) == 1'800'000'000);
  CHECK(peak_bytes(1, 16) == 1'300'000'000);
  const Bill bill = bill_of(two_sizes(), counts, two_conditions(), {.threads = 2});
  CHECK_THAT(to_text(two_sizes(), bill, two_conditions(), {}), Catch::Contains("next condition's scene"));
}

TEST_CASE("a bill compares time, money and disk with what there is") {
  const Recipe recipe = two_sizes();
  const Pilot pilot = two_conditions();
  const Bill bill = bill_of(recipe, counts, pilot, {});
  Resources resources{.cores = 4, .price_per_core_h = 0.5, .folder = "here", .free_bytes = 3.36e6 + 1};
  const nlohmann::ordered_json json = to_json(recipe, bill, pilot, resources);
  CHECK(json.at("wall_h").get<double>() == Approx(bill.core_h / 4));
  CHECK(json.at("cost").get<double>() == Approx(bill.core_h / 2));
  CHECK(json.at("fits_disk") == true);
  CHECK_THAT(to_text(recipe, bill, pilot, resources), !Catch::Contains("NOT ENOUGH"));
  resources.free_bytes = 3.36e6 - 1;
  CHECK(to_json(recipe, bill, pilot, resources).at("fits_disk") == false);
  CHECK_THAT(to_text(recipe, bill, pilot, resources), Catch::Contains("NOT ENOUGH"));
}
