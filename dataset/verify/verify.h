#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cps {

/// How much `verify_dataset` checked, and one line per fault that it found, file first.
struct VerifySummary {
  std::int64_t groups = 0, images = 0, masters = 0, dense = 0;  ///< dense: files of dense labels
  bool has_record = true;  ///< whether there is a dataset.json to compare the files with
  /// Largest distance between a pixel and distort(undistort(pixel)), over a grid of pixels of every group.
  double max_roundtrip_px = 0;
  static constexpr double no_rim = 1e30;
  /// Smallest distance from the frame to the master's rim seen through the lens; negative: the rim lies
  /// inside.
  double min_rim_margin_px = no_rim;
  std::vector<std::string> faults;
  /// Whether any image was warped from a master; those of other lens families are not.
  bool has_masters() const { return min_rim_margin_px < no_rim; }
  std::string brief() const;
};

/// Checks a finished dataset of any lens family against itself and trusts nothing that can be computed again:
/// every label (K against fov, certificate, crop, limits, true angles; mask of valid pixels), every image
/// (present, size, SHA-256 of the file, decodable, pixel hash of its list), every kept master and dense
/// label, frames.csv (poses against the rig's), and the split lists (every image once, no lens and no street
/// in two parts, unless the recipe's split is `thesis`). Of a dataset that cps relens made, which has no
/// dataset.json and no frames.csv, the labels, the lists, and presence and size of the images are checked.
/// Faults are collected; std::runtime_error is thrown only for a folder that cannot be read as a dataset or
/// is not finished.
VerifySummary verify_dataset(const std::filesystem::path& root);

}  // namespace cps
