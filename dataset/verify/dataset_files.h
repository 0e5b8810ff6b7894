#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dataset/job/frames.h"
#include "dataset/labels/reader.h"

namespace cps {

/// One line each, file first.
using Faults = std::vector<std::string>;

/// What a dataset says about itself, read once for all checks.
struct DatasetFiles {
  Dataset dataset;
  /// dataset.json. A set that cps relens made has none, or one that says no more than its lens family, and no
  /// frames.csv.
  std::optional<nlohmann::json> description = {};
  std::map<std::string, FrameRow> frames = {};  ///< by image, relative to the dataset
  std::set<std::size_t> unreadable = {};        ///< groups whose frames.csv cannot be read
  std::set<std::string> images = {};            ///< files in the leaf folders, relative to the dataset
  std::set<std::string> dense = {};             ///< likewise, those of dense labels

  /// The image's line of frames.csv; null when there is none.
  const FrameRow* frame_of(const std::filesystem::path& image) const;
  /// The file's list in dataset.json; empty when there is none.
  nlohmann::json list(const char* key) const;
};

/// What tells the streets of a condition's scene from others': those of a city are the same on all its days.
/// `scenes`: those of dataset.json.
std::string streets_of(const nlohmann::json& scenes, const nlohmann::json& condition);

/// Reads the labels, the split lists and dataset.json, no frames.csv. Throws std::runtime_error with one line
/// when the folder is not a finished dataset, or has lenses of a family that is not asked for.
DatasetFiles open_dataset(const std::filesystem::path& root,
                          LensFamilies families = LensFamilies::brown_conrady);

/// Reads everything but pixels: as open_dataset(), and every frames.csv. Adds a fault for each frames.csv
/// that cannot be read. Throws as open_dataset() does.
DatasetFiles read_dataset_files(const std::filesystem::path& root, Faults& faults,
                                LensFamilies families = LensFamilies::brown_conrady);

}  // namespace cps
