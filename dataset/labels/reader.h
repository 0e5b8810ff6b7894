#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/labels/label.h"

namespace cps {

/// One leaf folder.
struct DatasetGroup {
  std::filesystem::path folder;  ///< relative to the dataset: 480x270_hfov090/front_lens0003
  Label label;
};

struct DatasetImage {
  std::filesystem::path file;  ///< relative to the dataset: <group folder>/000017.png
  int group = 0;               ///< index into Dataset::groups
  Part part = Part::train;     ///< from splits/*.txt, never `all`
};

struct Dataset {
  std::filesystem::path root;
  std::vector<DatasetGroup> groups;  ///< sorted by folder
  std::vector<DatasetImage> images;  ///< in the order of the split lists: train, val, test
};

/// Reads the labels (every calibration.json) and the split lists of a finished dataset; no pixels. Throws
/// std::runtime_error with one line: folder or file, what is wrong, what to do.
Dataset read_dataset(const std::filesystem::path& root);

}  // namespace cps
