#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cps {

/// What `verify_dataset` looked at and what it found wrong: one line per fault, file first.
struct VerifySummary {
  std::int64_t groups = 0, images = 0, masters = 0;
  double worst_roundtrip_px = 0;  ///< distort(undistort(pixel)) against the pixel, over a grid of every group
  double least_rim_margin_px =
      1e30;  ///< how far outside the frame the master's rim lies at its nearest; negative: inside
  std::vector<std::string> faults;
  std::string brief() const;
};

/// Checks a finished dataset against itself, trusting nothing that can be computed again: every label (K
/// against fov, certificate, crop, limits, true angles), every image (present, size, SHA-256 of the file,
/// decodable, pixel hash of its list), every kept master, frames.csv and the split lists (every image once,
/// no lens and no street in two parts, unless the recipe's split is `thesis`). Faults are collected; only a
/// dataset that cannot be read at all throws std::runtime_error.
VerifySummary verify_dataset(const std::filesystem::path& root);

}  // namespace cps
