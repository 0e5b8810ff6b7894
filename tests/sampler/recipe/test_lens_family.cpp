#include <boost/program_options.hpp>
#include <catch2/catch.hpp>
#include <fstream>

#include "sampler/recipe/recipe.h"
#include "tests/temporary_folder.h"

namespace po = boost::program_options;
using namespace cps;

namespace {

/// The recipe of a file with these lines and what every recipe needs.
Recipe family_recipe(const std::string& lines) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "recipe.cfg";
  std::ofstream(file) << "scene = a.glb\nsize = 96x72\nviews = 10\n" << lines;
  po::variables_map values;
  store_recipe_file(file, values);
  return recipe_from(values);
}

}  // namespace

TEST_CASE("a recipe with another lens family reads back to itself and has no undistorted images") {
  const Recipe recipe =
      family_recipe("lens_model = kannala_brandt\nhfov_deg = 100, 195\nlenses = 2\nlabels = depth\n");
  CHECK_FALSE(recipe.is_brown_conrady());
  CHECK_FALSE(recipe.undistorted);
  CHECK(recipe.fault() == "");
  const std::string text = to_text(recipe);
  CHECK_THAT(text, Catch::Contains("\nlens_model = kannala_brandt\n"));
  const TemporaryFolder folder;
  std::ofstream(folder.path / "again.cfg") << text;
  po::variables_map values;
  store_recipe_file(folder.path / "again.cfg", values);
  CHECK(to_text(recipe_from(values)) == text);
}

TEST_CASE("the text of a Brown-Conrady recipe does not know of other families") {
  const Recipe recipe = family_recipe("base_hfov_deg = 90\nlens_model = brown_conrady\n");
  CHECK(recipe.is_brown_conrady());
  CHECK(recipe.undistorted);
  CHECK_THAT(to_text(recipe), !Catch::Contains("lens_model"));
}

TEST_CASE("keys that only Brown-Conrady lenses and masters have are refused by name with another family") {
  const std::string family = "lens_model = eucm\nlenses = 1\n";
  const auto refusal = [&](const std::string& lines) -> std::string {
    try {
      family_recipe(lines);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal(family + "hfov_deg = 120\n") == "");
  const std::pair<const char*, const char*> cases[] = {
      {"base_hfov_deg = 90", "recipe: base_hfov_deg: is an H-FOV before a crop"},
      {"hfov_deg = 196", "recipe: hfov_deg: must lie in [5, 195]"},
      {"hfov_deg = 120\nundistorted = true", "recipe: undistorted: must be false"},
      {"hfov_deg = 120\nkeep_masters = true", "recipe: keep_masters: must be false"},
      {"hfov_deg = 120\nsamples = 16386", "recipe: samples: must lie in [2, 16384]"},
      {"hfov_deg = 120\nlens_draw = shape_prior", "recipe: lens_draw: is for brown_conrady lenses"},
      {"hfov_deg = 120\nsequential_share = 0.3", "recipe: sequential_share: is for brown_conrady lenses"},
      {"hfov_deg = 120\nreal_lenses_share = 0.3", "recipe: real_lenses_share: is for brown_conrady lenses"},
      {"hfov_deg = 120\ncoefficients = k1", "recipe: coefficients: is for brown_conrady lenses"},
      {"hfov_deg = 120\nk1_min = -0.2", "recipe: k1_min: is for brown_conrady lenses"},
      {"hfov_deg = 120\nmin_eigenvalue = 0.1", "recipe: min_eigenvalue: is for brown_conrady lenses"},
      {"hfov_deg = 120\nmax_zoom = 2", "recipe: max_zoom: is for brown_conrady lenses"},
      {"hfov_deg = 120\nprincipal_point_x = 0", "recipe: principal_point_x: is for brown_conrady lenses"},
  };
  for (const auto& [line, expected] : cases) {
    INFO(line);
    CHECK_THAT(refusal(family + line + "\n"), Catch::StartsWith(expected) && !Catch::Contains("\n"));
  }
  CHECK_THAT(refusal("hfov_deg = 90\nlens_model = fisheye\nlenses = 1\n"),
             Catch::StartsWith("recipe: lens_model: must be one of brown_conrady, unified_spherical, "
                               "kannala_brandt, eucm, double_sphere"));
  CHECK_THAT(refusal("lens_model = eucm\nhfov_deg = 120\n"), Catch::Contains("lenses: must lie in [1, "));
  CHECK_THAT(refusal("hfov_deg = 166\n"), Catch::Contains("must lie in [5, 165]"));
}
