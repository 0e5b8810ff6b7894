#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "dataset/export/export.h"
#include "files/files.h"
#include "tests/dataset/export/dense_dataset.h"
#include "tests/dataset/small_dataset.h"

namespace cps {

/// A small dataset and one export of it.
struct Exported {
  TemporaryFolder temporary;
  std::filesystem::path root = temporary.path / "data", out = temporary.path / "out";
  Plan plan = small_plan();

  Exported() { write_small_dataset(root, plan); }
  explicit Exported(ExportTarget target) : Exported() { write(out, {.target = target}); }

  ExportSummary write(
      const std::filesystem::path& folder, const ExportOptions& options,
      const ExportProgress& progress = [](std::int64_t, const std::string&) {}) const {
    return export_dataset(read_export_source(root), folder, options, progress);
  }
};

/// The same with all dense labels.
struct Labelled : Exported {
  Labelled() { add_dense_labels(root); }
  explicit Labelled(ExportTarget target) : Labelled() { write(out, {.target = target}); }
};

/// The bytes of every file below a folder, by name.
inline std::map<std::string, std::string> bytes_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path());
  return files;
}

}  // namespace cps
