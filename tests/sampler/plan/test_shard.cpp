#include <catch2/catch.hpp>

#include "sampler/plan/shard.h"

using namespace cps;

namespace {

/// Views of two sizes in four conditions, in the plan's order.
Plan plan_of_two_sizes(int views_per_condition) {
  Plan plan;
  for (int condition = 0; condition < 4; ++condition)
    for (int i = 0; i < views_per_condition; ++i) {
      PlannedView view;
      view.condition = condition;
      view.master.width = i < views_per_condition / 2 ? 400 : 1200;
      view.master.height = 300;
      plan.views.push_back(view);
    }
  return plan;
}

}  // namespace

TEST_CASE("the shards of one count have every view once, in order, however many they are") {
  const Plan plan = plan_of_two_sizes(10);
  for (std::int64_t count : {1, 2, 3, 7, 39, 40, 41, 200}) {
    std::int64_t next = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const ViewRange range = views_of(plan, {i, count});
      CHECK(range.begin == next);
      CHECK(range.end >= range.begin);
      next = range.end;
    }
    CHECK(next == 40);
  }
  CHECK(views_of(Plan{}, {0, 1}).end == 0);
}

TEST_CASE("shards have equally much to render, within a view") {
  const Plan plan = plan_of_two_sizes(50);
  double total = 0;
  for (const PlannedView& view : plan.views) total += view.master.width;
  for (std::int64_t count : {2, 3, 7, 20}) {
    for (std::int64_t i = 0; i < count; ++i) {
      double width = 0;
      const ViewRange range = views_of(plan, {i, count});
      for (std::int64_t v = range.begin; v < range.end; ++v) width += plan.views[v].master.width;
      CHECK(std::abs(width - total / static_cast<double>(count)) <= 1200);
    }
  }
  // Four conditions, four shards: a condition each.
  for (std::int64_t i = 0; i < 4; ++i) CHECK(views_of(plan, {i, 4}).begin == 50 * i);
}

TEST_CASE("shards are written as index and count, from 0") {
  CHECK(shard_from_string("0/1") == Shard{0, 1});
  CHECK(shard_from_string("12/1000") == Shard{12, 1000});
  CHECK(to_string(Shard{3, 4}) == "3/4");
  CHECK_THROWS_WITH(shard_from_string("4/4"),
                    Catch::Contains("count from 0") && Catch::Contains("[0/4, 3/4]"));
  CHECK_THROWS_WITH(shard_from_string("-1/4"), Catch::Contains("count from 0"));
  CHECK_THROWS_WITH(shard_from_string("0/0"), Catch::Contains("[1, 1000000]"));
  for (const char* text :
       {"", "/", "1", "1/", "/2", "a/b", "1/2/3", "1 / 2", "0x1/2", "99999999999999999999/2"})
    CHECK_THROWS_WITH(shard_from_string(text), Catch::Contains("0/4"));
}
