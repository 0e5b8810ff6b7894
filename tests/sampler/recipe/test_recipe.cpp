#include <boost/program_options.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "sampler/recipe/recipe.h"
#include "sampler/recipe/recipe_keys.h"
#include "tests/temporary_folder.h"

namespace po = boost::program_options;
using namespace cps;

namespace {

/// Parses recipe text as generate does, after writing it to a file.
Recipe recipe_of(const std::string& text, const std::vector<std::string>& flags = {}) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "recipe.cfg";
  std::ofstream(file) << text;
  po::variables_map values;
  po::store(po::command_line_parser(flags).options(recipe_options()).run(), values);
  store_recipe_file(file, values);
  return recipe_from(values);
}

const std::string whole = "scene = a.glb\nsize = 480x270\nbase_hfov_deg = 90\nviews = 10\n";

}  // namespace

TEST_CASE("a recipe file is read, lists and all, and flags override it") {
  const Recipe recipe = recipe_of(
      "# a comment\nname = try\nseed = 18446744073709551615\nscene = a.glb, b/c.gltf\ncity_seed = 0, "
      "7\ncity_style = suburb, mixed\n"
      "size = 1392x512, 480x270\nbase_hfov_deg = 50, 90.5,130\nviews = 12\nlenses = 3\nmax_zoom = 1.75\n"
      "lens_draw = shape_prior\n",
      {"--views", "24"});
  CHECK(recipe.name == "try");
  CHECK(recipe.seed == 18446744073709551615ull);
  CHECK(recipe.scenes == std::vector<std::string>{"a.glb", "b/c.gltf"});
  CHECK(recipe.city_seeds == std::vector<std::uint64_t>{0, 7});
  CHECK(recipe.city_styles == std::vector{CityStyle::suburb, CityStyle::mixed});
  REQUIRE(recipe.sizes.size() == 2);
  CHECK(recipe.sizes[0].width == 1392);
  CHECK(recipe.sizes[0].height == 512);
  CHECK(recipe.base_hfov_deg == std::vector<double>{50, 90.5, 130});
  CHECK(recipe.views == 24);
  CHECK(recipe.lens_options.principal_point.max_zoom == 1.75);
  CHECK(recipe.lens_options.scheme == LensScheme::shape_prior);
}

TEST_CASE("keys may be written with - for _, in the file and nowhere else") {
  const Recipe recipe = recipe_of(
      "name = a-b_c\nscene = my-city.glb\nsize = 480x270\nbase-hfov-deg = 90\n  views-per_lens = 3\nviews = 10\n");
  CHECK(recipe.name == "a-b_c");
  CHECK(recipe.scenes == std::vector<std::string>{"my-city.glb"});
  CHECK(recipe.base_hfov_deg == std::vector<double>{90});
  CHECK(recipe.views_per_lens == 3);
  CHECK_THROWS_WITH(recipe_of("no-such-key = 1\n" + whole), Catch::Contains("no_such_key"));
}

TEST_CASE("file names may have spaces and any letters, in the file and as options") {
  const std::vector<std::string> files{"my city.glb", "straße/Käfig 2.gltf", "c.glb"};
  const Recipe from_file = recipe_of(
      "scene =  my city.glb , straße/Käfig 2.gltf,c.glb\nrig = our car.rig\nsize = 480x270\nbase_hfov_deg = 90\n"
      "views = 10\n");
  CHECK(from_file.scenes == files);
  CHECK(from_file.rig == "our car.rig");
  CHECK(recipe_of(to_text(from_file)).scenes == files);
  const Recipe from_options =
      recipe_of("size = 480x270 64x64\nbase_hfov_deg = 90\nviews = 10\n",
                {"--scene", "my city.glb,straße/Käfig 2.gltf, c.glb", "--rig", "our car.rig"});
  CHECK(from_options.scenes == files);
  CHECK(from_options.rig == "our car.rig");
  CHECK(from_options.sizes.size() == 2);  // numbers may be separated by spaces alone
  for (const std::vector<std::string>& bad :
       {std::vector<std::string>{"--scene", "a#1.glb"}, {"--rig", "a\nb.rig"}, {"--name", "#1"}})
    CHECK_THROWS_WITH(recipe_of(whole, bad), Catch::Contains(bad[0].substr(2) + ": ") &&
                                                 Catch::Contains("must not contain # or a line break"));
}

TEST_CASE("scenes named on the command line replace the recipe file's scenes and cities") {
  const std::string file =
      "scene = a.glb\ncity_seed = 1, 2\ncities = 3\nsize = 480x270\nbase_hfov_deg = 90\nviews = 10\n";
  const Recipe as_it_stands = recipe_of(file);
  CHECK(as_it_stands.scenes.size() + as_it_stands.city_seeds.size() + as_it_stands.cities == 6);
  const Recipe one_scene = recipe_of(file, {"--scene", "b.glb"});
  CHECK(one_scene.scenes == std::vector<std::string>{"b.glb"});
  CHECK(one_scene.city_seeds.empty());
  CHECK(one_scene.cities == 0);
  const Recipe drawn_cities = recipe_of(file, {"--cities", "5"});
  CHECK(drawn_cities.scenes.empty());
  CHECK(drawn_cities.city_seeds.empty());
  CHECK(drawn_cities.cities == 5);
}

TEST_CASE("a recipe written out reads back to itself") {
  Recipe recipe = recipe_of(whole);
  recipe.lens_options.bounds.max_displacement = 1.0 / 3.0;
  recipe.lens_options.scheme = LensScheme::shape_prior;
  recipe.sensor.full_well_min_e = 1.3;
  recipe.sensor.full_well_max_e = 12345.678;
  const std::string text = to_text(recipe);
  CHECK(to_text(recipe_of(text)) == text);
  CHECK(recipe_of(text).lens_options.bounds.max_displacement == 1.0 / 3.0);
}

TEST_CASE("keys that came later are listed only where they are not at their defaults") {
  for (const auto& [key, value] : later_recipe_keys) {
    INFO(key);
    // The text of the default is what is left out.
    CHECK(to_text(recipe_of(whole + std::string(key) + " = " + std::string(value) + "\n")) ==
          to_text(recipe_of(whole)));
    CHECK_THAT(to_text(recipe_of(whole)), !Catch::Contains(std::string(key)));
  }
  const Recipe turned = recipe_of(whole + "camera_pitch_min_deg = -15\ncamera_roll_max_deg = 10\n");
  const std::string text = to_text(turned);
  CHECK_THAT(text, Catch::Contains("camera_pitch_min_deg = -15\n"));
  CHECK_THAT(text, !Catch::Contains("camera_pitch_max_deg"));
  CHECK(recipe_of(text).camera_roll_max_deg == 10);
  const std::string mixed = to_text(recipe_of(
      whole + "lens_draw = shape_prior\nreal_lenses_share = 0.4\nsensor_binning = 2\nlenses = 1\n"));
  CHECK_THAT(mixed, Catch::Contains("real_lenses_share = 0.4\n") && Catch::Contains("sensor_binning = 2\n"));
  CHECK(recipe_of(mixed).lens_options.real_lenses_share == 0.4);
  CHECK(recipe_of(mixed).sensor.binning == 2);
}

TEST_CASE("a recipe that cannot be is refused by the key's name") {
  const auto refusal = [&](const std::string& line) -> std::string {
    try {
      recipe_of(line + "\n" + whole);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::pair<const char*, const char*> cases[] = {
      {"viws = 3", "viws"},
      {"samples = many", "samples = many: is not a whole number"},
      {"samples = 0", "samples: must be even, in [2, 65536]"},
      {"samples = 3", "samples: must be even, in [2, 65536]"},
      {"city_style = village", "city_style = village: is none of european, downtown"},
      {"lenses = 3.5", "lenses"},
      {"lenses = -1", "lenses: must lie in"},
      {"seed = -1", "seed"},
      {"sun_elevation_min_deg = nan", "sun_elevation"},
      {"day_min = 0", "day_min ≤ day_max: must lie in [1, 365]"},
      {"clear_share = 0.9\nhazy_share = 0.2", "clear_share, hazy_share"},
      {"latitude_deg = 91", "latitude_deg: must lie in [-90, 90]"},
      {"traffic_max = 3", "traffic_min ≤ traffic_max: must lie in [0, 2]"},
      {"ego_bonnet = 1", "ego_bonnet = 1: is neither true nor false"},
      {"cities = -1", "cities: must lie in"},
      {"camera_pitch_min_deg = 5", "camera_pitch_min_deg ≤ camera_pitch_max_deg"},
      {"camera_roll_max_deg = 50", "camera_roll_min_deg ≤ camera_roll_max_deg"},
      {"conditions_per_scene = 0", "conditions_per_scene: must lie in"},
      {"clearance_m = 1e9", "clearance_m"},
      {"split = random", "split: must be route or thesis"},
      {"max_displacement = -1", "max_displacement"},
      {"max_zoom = 0.5", "max_zoom"},
      {"lens_draw = clamped", "lens_draw = clamped: is not one of sequential, shape_prior, real_lenses"},
      {"sequential_share = 1.5", "sequential_share"},
      {"real_lenses_share = 0.5", "real_lenses_share: needs lens_draw = shape_prior"},
      {"lens_draw = real_lenses\nreal_lenses_share = 0.5",
       "real_lenses_share: needs lens_draw = shape_prior"},
      {"lens_draw = shape_prior\nreal_lenses_share = -0.1",
       "sequential_share, real_lenses_share: must lie in"},
      {"lens_draw = shape_prior\nsequential_share = 0.5\nreal_lenses_share = 0.6",
       "sequential_share, real_lenses_share: must lie in [0, 1], and their sum too"},
      {"hfov_deg = 90", "base_hfov_deg, hfov_deg: one follows from the other"},
      {"full_well_min_e = 0", "full_well_min_e"},
      {"contrast_min = 2", "contrast_min ≤ contrast_max must lie in [0.25, 4]"},
      {"sensor_binning = 0", "sensor_binning: must lie in [1, 16]"},
      {"sensor_binning = 17", "sensor_binning: must lie in [1, 16]"},
      {"sensor_binning = 1.5", "sensor_binning = 1.5: is not a whole number"},
      {"lenses = 1, 2", "lenses: name one number, or as many as there are sizes"},
      {"undistorted = false", "lenses: must lie in [1, 10000] where undistorted = false"},
      {"coefficients = k1, k4", "coefficients = k1, k4: is not made of k1, k2, k3, p1, p2"},
      {"coefficients =", "coefficients: name at least one of k1, k2, k3, p1, p2"},
      {"lens_draw = shape_prior\ncoefficients = k1",
       "coefficients, k1_min, k1_max: need lens_draw = sequential"},
      {"k1_min = 0.1", "k1_min ≤ 0 ≤ k1_max"},
      {"min_eigenvalue = 1.5", "min_eigenvalue"},
      {"scale = 0", "scale: must be above 0 and at most 100"},
      {"lenses = 1\nlens_draw = shape_prior\nsequential_share = 0\nmax_displacement = 1e-6",
       "recipe: 480x270, 90 degrees: no lens within the bounds"},
  };
  for (const auto& [line, expected] : cases) {
    INFO(line);
    CHECK_THAT(refusal(line), Catch::Contains(expected));
    CHECK_THAT(refusal(line), !Catch::Contains("\n"));
  }
  CHECK_THROWS_WITH(recipe_of("size = 480x270\nbase_hfov_deg = 90\nviews = 10\n"), Catch::Contains("scene"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 480x270\nviews = 10\n"), Catch::Contains("hfov_deg"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 480\nbase_hfov_deg = 90\nviews = 10\n"),
                    Catch::Contains("1392x512"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 0x270\nbase_hfov_deg = 90\nviews = 10\n"),
                    Catch::Contains("size"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = -480x270\nbase_hfov_deg = 90\nviews = 10\n"),
                    Catch::Contains("size: width and height must be at least 32"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 480x270\nbase_hfov_deg = 0\nviews = 10\n"),
                    Catch::Contains("base_hfov_deg, hfov_deg: must lie in [5, 165]"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 480x270\nbase_hfov_deg = 90\nviews = 0\n"),
                    Catch::Contains("views: must lie in [3, 1000000]"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 480x270\nhfov_deg = 90\nviews = 3\nk1_max = 0.1\n"),
                    Catch::Contains("k1_min, k1_max: need base_hfov_deg"));
  CHECK_THROWS_WITH(recipe_of("scene = a\nsize = 48x48\nbase_hfov_deg = 180\nviews = 10\n"),
                    Catch::Contains("base_hfov_deg"));
}
