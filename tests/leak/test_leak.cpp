#include <catch2/catch.hpp>

#include "tests/leak/probe.h"

using namespace cps;

namespace {

constexpr int train_count = 10'000, test_count = 5'000, epochs = 5, wall_side_px = 1'500;
constexpr double harmless = 0.02;  ///< share of a secret's variance that may be explained

std::array<Guess, secret_count> guess_from_noise(WallLight light, int samples, Resampler resampler) {
  const NoiseWall train_wall = render_noise_wall(light, samples, wall_side_px, 1),
                  test_wall = render_noise_wall(light, samples, wall_side_px, 2);
  const auto guesses =
      probe(photograph_wall(train_wall, resampler, train_count, make_stream(1, "leak training")),
            photograph_wall(test_wall, resampler, test_count, make_stream(2, "leak test")), epochs, 1);
  std::string line = "render noise " + std::to_string(relative_noise(test_wall)) + ":";
  for (int s = 0; s < secret_count; ++s)
    line += std::string("  ") + secret_names[s] + " " + std::to_string(guesses[s].r_squared) + " (" +
            std::to_string(guesses[s].lower) + " to " + std::to_string(guesses[s].upper) + ")";
  WARN(line);
  return guesses;
}

}  // namespace

TEST_CASE("the wall is the same everywhere but for its noise") {
  for (const WallLight light : {WallLight::shade, WallLight::sunlit}) {
    const NoiseWall wall = render_noise_wall(light, 8, 256, 3);
    const OIIO::ImageBuf& picture = wall.master.picture;
    // Means of 8 × 8 blocks of 32 × 32 pixels, in their standard errors: χ² with 63 degrees of freedom.
    const double deviation = relative_noise(wall) / 32;
    std::vector<double> means(64);
    double all = 0;
    for (int block = 0; block < 64; ++block) {
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          means[block] += picture.getchannel(block % 8 * 32 + x, block / 8 * 32 + y, 0, 1) / 1024;
      all += means[block] / 64;
    }
    double chi_squared = 0;
    for (const double mean : means) chi_squared += std::pow((mean / all - 1) / deviation, 2);
    CHECK(deviation > 0);
    CHECK(chi_squared < 113);  // 1e-4
  }
}

TEST_CASE("render noise through photograph() reveals nothing of the lens", "[slow]") {
  for (const WallLight light : {WallLight::shade, WallLight::sunlit})
    for (const int samples : {2, 16}) {
      CAPTURE(int(light), samples);
      for (const Guess& guess : guess_from_noise(light, samples, Resampler::pipeline))
        CHECK(guess.upper < harmless);
    }
}

// Two probes; a test of its own so that it runs beside the four above.
TEST_CASE("the probe finds what other ways of resampling reveal", "[.control]") {
  // A picture of the output's size, 8 bit, bilinear: the spectrum of its noise is a map of the lens.
  const auto planted = guess_from_noise(WallLight::sunlit, 16, Resampler::bilinear_8bit);
  CHECK(planted[0].lower > harmless);
  CHECK(planted[1].lower > harmless);
  CHECK(planted[2].lower > harmless);
  // Footprints without added noise: the level of the render's noise is.
  const auto unguarded = guess_from_noise(WallLight::shade, 2, Resampler::unguarded);
  CHECK(unguarded[0].lower > harmless);
  CHECK(unguarded[2].lower > harmless);
}
