#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/apps/cps_program.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

using namespace cps;
using Json = nlohmann::json;

TEST_CASE("plan counts what generate makes, and its sums hold") {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_cps("plan --scene " + write_street_gltf(folder.path).string() +
              " --size 96x54,110x40 --base_hfov_deg 60,90 --views 40,20 --lenses 2,3 --samples 2 --cores 4 "
              "--price 0.5 --shards 3 --json");
  INFO(run.output);
  REQUIRE(run.exit_status == 0);
  const Json bill = Json::parse(run.output);
  CHECK(bill.at("views") == 2 * (40 + 20));
  CHECK(bill.at("images") == 2 * (40 * 3 + 20 * 4));
  CHECK(bill.at("groups") == 2 * (1 + 3 * 2) + 2 * (1 + 3 * 3));
  const double all = bill.at("core_h");
  CHECK(all > 0);
  CHECK(double(bill.at("render_core_h")) + double(bill.at("images_core_h")) +
            double(bill.at("scenes_core_h")) + double(bill.at("start_core_h")) ==
        Approx(all));
  CHECK(bill.at("shards") == 3);
  CHECK(double(bill.at("start_core_h")) > 0);
  CHECK(double(bill.at("wall_h")) == Approx(all / 4));
  CHECK(double(bill.at("cost")) == Approx(all * 0.5));
  CHECK(double(bill.at("image_bytes")) > 400 * 1000.0);
  CHECK(bill.at("fits_disk") == true);

  // The time of a set is its number of images over its rate; the sum is that of rendering and making images.
  const std::vector<double> rates = bill.at("set_images_per_core_h"), images = {120, 120, 80, 80};
  REQUIRE(rates.size() == images.size());
  double hours = 0;
  for (std::size_t set = 0; set < rates.size(); ++set) hours += images[set] / rates[set];
  CHECK(hours == Approx(double(bill.at("render_core_h")) + double(bill.at("images_core_h"))));
}

TEST_CASE("plan counts the files of dense labels") {
  const TemporaryFolder folder;
  const std::string scene = write_street_gltf(folder.path).string();
  const auto image_bytes = [&](const std::string& labels) {
    const ProgramRun run =
        run_cps("plan --scene " + scene +
                " --size 96x54 --base_hfov_deg 60 --views 4 --lenses 1 --samples 2 --json" + labels);
    INFO(run.output);
    REQUIRE(run.exit_status == 0);
    return Json::parse(run.output).at("image_bytes").get<double>();
  };
  // Rays are three floats a pixel, of which ZIP leaves most.
  const double rays_bytes = image_bytes(" --labels rays") - image_bytes("");
  CHECK(rays_bytes > 0.5 * 8 * 96 * 54 * 12);
  CHECK(rays_bytes < 1.1 * 8 * 96 * 54 * 12);
}

TEST_CASE("plan refuses impossible options in one line") {
  check_refused("plan --cores 0", 2, "--cores: must lie in");
  check_refused("plan --price -1", 2, "--price: must lie in");
  check_refused("plan --shards 0", 2, "--shards: must lie in");
  check_refused("plan --conditions 0", 2, "--conditions: must lie in");
  check_refused("plan --recipe no-such-recipe", 1, "no-such-recipe: cannot be read");
}
