#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "dataset/export/export.h"
#include "dataset/export/source.h"
#include "files/file_lock.h"
#include "files/pieces.h"

namespace cps {

/// A file of an export as an index names it.
struct ExportedFile {
  std::string name;  ///< relative to the export's folder
  std::int64_t samples = 0;
  std::uint64_t bytes = 0;
  std::string sha256 = {};
};

/// The folder that an export is written to. Until the export is finished it holds .cps/, whose export.json
/// says what is being written; then the same text stands in export.json, and .cps/ is gone.
class ExportFolder {
 public:
  /// Begins an export in `out` or goes on with it. Throws as export_dataset() does.
  ExportFolder(const std::filesystem::path& out, const ExportSource& source, const ExportOptions& options);

  /// Whether the folder already holds this export, complete.
  bool is_finished() const { return is_finished_; }

  std::filesystem::path at(const std::filesystem::path& name) const { return out_ / name; }

  /// Makes `name` a hard link to the image; or a copy where the file system allows no link, or copies are
  /// wanted. Keeps a file that is there.
  void add_image(const ExportSource& source, const DatasetImage& image, const std::filesystem::path& name);
  /// The same with the file of one of its dense labels.
  void add_dense(const ExportSource& source, const DatasetImage& image, DenseLabel label,
                 const std::filesystem::path& name);

  /// Writes a file that `produce` appends piece by piece, and hashes it; `samples` is left to the caller.
  ExportedFile write(const std::string& name, const std::function<void(const Append&)>& produce) const;

  /// The file of that name if it was recorded and its bytes still have the recorded hash.
  std::optional<ExportedFile> kept(const std::string& name) const;
  /// Remembers a finished file for kept(), until the export is finished.
  void record(const ExportedFile& file);

  /// Writes export.json and removes .cps/.
  void finish();

 private:
  void add(const std::filesystem::path& from, const std::filesystem::path& name,
           const std::function<std::string()>& read);
  std::filesystem::path record_of(const std::string& name) const;

  std::filesystem::path out_;
  std::string request_;  ///< text of export.json
  bool copy_, is_finished_ = false;
  std::optional<FileLock> lock_;
};

}  // namespace cps
