#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "dataset/export/source.h"

/// A finished dataset in the layouts that other programs read. docs/formats.md describes each of them.
namespace cps {

enum class ExportTarget { webdataset, huggingface, colmap, nerfstudio, kitti, coco };

std::string to_string(ExportTarget target);
/// Reads what to_string() writes. Throws std::runtime_error that lists the known targets.
ExportTarget export_target_from_string(const std::string& name);

struct ExportOptions {
  ExportTarget target = ExportTarget::webdataset;
  int shard_mb = 256;  ///< webdataset: most bytes of a tar, in millions; a larger image gets a tar of its own
  bool copy = false;   ///< copy images where they could be hard links
  /// huggingface: what only the publisher of a dataset knows. Empty: left out.
  std::string license = {};    ///< an identifier such as cc-by-4.0
  std::string url = {};        ///< of the dataset's page
  std::string creator = {};    ///< a person or an organisation
  std::string published = {};  ///< YYYY-MM-DD

  /// The names and values of these four.
  std::array<std::pair<const char*, const std::string*>, 4> publication() const;
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

struct ExportSummary {
  bool was_finished = false;  ///< the folder held this very export already
  std::string note = {};      ///< what the export lacks and how to get it; empty if nothing
};

/// Told of images that have reached the export: how many more, and the last of them. May throw to stop.
using ExportProgress = std::function<void(std::int64_t more, const std::string& current)>;

/// Writes the dataset to the folder `out`, which must be new or empty, or hold a begun export of the
/// same dataset with the same options: then goes on with it. Every file appears by rename, and export.json is
/// the last of them. The same dataset and options give the same bytes.
///
/// Throws std::runtime_error with one line: for a folder with other things in it, a folder inside the
/// dataset, a target that needs poses or labels which the dataset lacks, a damaged image, a full disk. Throws
/// HeldByAnother while another process writes there.
ExportSummary export_dataset(const ExportSource& source, const std::filesystem::path& out,
                             const ExportOptions& options, const ExportProgress& progress);

}  // namespace cps
