#pragma once

#include <array>
#include <cstdint>

#include "tests/leak/wall_pictures.h"

namespace cps {

/// How well a network guesses one secret of pictures that it has not seen: the squared correlation of guess
/// and truth (0 where the correlation is negative), with the ends of its one-sided 95 %
/// confidence intervals (Fisher 1921).
struct Guess {
  double r_squared = 0, lower = 0, upper = 0;
};

/// Trains a small convolutional network on `train` and has it guess the secrets of `test`. It sees
/// differences between neighbours at full resolution and keeps where in the picture they are.
std::array<Guess, secret_count> probe(const WallPictures& train, const WallPictures& test, int epochs,
                                      std::uint64_t seed);

}  // namespace cps
