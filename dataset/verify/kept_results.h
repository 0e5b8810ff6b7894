#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/verify/registration.h"
#include "dataset/verify/verify.h"

/// What `cps verify` found, kept in the dataset's `.cps/` for its report.
namespace cps {

/// `.cps/verify.json`.
struct KeptVerification {
  std::string generator;  ///< program and version that checked
  /// Of dataset.json as it was then: another dataset.json was not checked. Empty if there was none.
  std::string dataset_sha256;
  std::int64_t groups = 0, images = 0, masters = 0;
  double max_roundtrip_px = 0, min_rim_margin_px = 0;
  bool is_planned_again = false;  ///< labels and poses were compared with the recipe's plan
  std::int64_t faults = 0;
  std::vector<std::string> first_faults;
};

/// An image of the dataset that was rendered again.
struct RerenderedImage {
  std::string file;
  Registration registration = {};
  std::string fault = {};  ///< empty: agrees
};

/// `.cps/rerender.json`.
struct KeptRerender {
  int samples = 0;                                ///< per pixel
  double max_shift_px = 0, max_block_rms_px = 0;  ///< allowed
  std::vector<RerenderedImage> images;
};

/// Writes the file. Throws std::runtime_error naming it when it cannot be written.
void keep_verification(const std::filesystem::path& root, const VerifySummary& summary,
                       bool is_planned_again);
void keep_rerender(const std::filesystem::path& root, const KeptRerender& rerender);

/// Reads the file, if there is one. Throws std::runtime_error with one line: file, key, what is wrong.
std::optional<KeptVerification> kept_verification(const std::filesystem::path& root);
std::optional<KeptRerender> kept_rerender(const std::filesystem::path& root);

/// SHA-256 of the dataset's dataset.json; empty if there is none.
std::string description_sha256(const std::filesystem::path& root);

}  // namespace cps
