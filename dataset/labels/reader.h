#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/labels/label.h"
#include "dataset/labels/model_label.h"

namespace cps {

/// One leaf folder.
struct DatasetGroup {
  std::filesystem::path folder;  ///< relative to the dataset: 480x270_hfov090/front_lens0003
  Label label;
  /// Of a lens of another family; then `label` is common_label() of it. Only with LensFamilies::any.
  std::optional<ModelLabel> model = {};

  /// The camera and its lens, of whatever family, with the rig camera's name.
  ModelCamera camera() const {
    return model ? model->camera : ModelCamera{label.rig_camera, label.camera, label.distortion};
  }
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

/// Which lenses a reader of datasets knows what to do with.
enum class LensFamilies { brown_conrady, any };

/// Reads the labels (every calibration.json) and the split lists of a finished dataset; no pixels. Its labels
/// may be of several families. Throws std::runtime_error with one line: folder or file, what is wrong, what
/// to do. A label of a family that is not asked for is refused by the family's name.
Dataset read_dataset(const std::filesystem::path& root, LensFamilies families = LensFamilies::brown_conrady);

}  // namespace cps
