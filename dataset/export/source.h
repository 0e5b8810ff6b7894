#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "dataset/verify/dataset_files.h"

namespace cps {

/// A dataset that is being exported.
struct ExportSource {
  DatasetFiles files;
  std::string name;     ///< of the recipe
  std::string credits;  ///< of its scenes, one a line; may be empty
  /// SHA-256 over the hashes of labels, lists and tables, which hold the hashes of the images.
  std::string sha256;
  /// What every image has, in the order of the columns of frames.csv; empty where there is none.
  std::vector<DenseLabel> dense_labels;

  const Dataset& dataset() const { return files.dataset; }
  const DatasetGroup& group_of(const DatasetImage& image) const { return dataset().groups[image.group]; }
  const Label& label_of(const DatasetImage& image) const { return group_of(image).label; }
  bool has_frames() const { return files.description.has_value(); }
  bool has(DenseLabel label) const;
  /// The image's line of frames.csv. Only where has_frames().
  const FrameRow& frame_of(const DatasetImage& image) const { return *files.frame_of(image.file); }
  /// The images of a part, in the order of its list.
  std::span<const DatasetImage> images_of(Part part) const;
};

/// Reads everything but pixels. Throws std::runtime_error with one line when the dataset is not finished or
/// its lists and tables disagree.
ExportSource read_export_source(const std::filesystem::path& root);

/// The bytes of an image's file. Throws std::runtime_error with one line when it cannot be read, or when its
/// hash is not that in frames.csv.
std::string read_image(const ExportSource& source, const DatasetImage& image);

/// The same of the file of a dense label that the source has.
std::string read_dense_bytes(const ExportSource& source, const DatasetImage& image, DenseLabel label);

}  // namespace cps
