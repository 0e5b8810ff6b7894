#pragma once

#include <string>

#include "dataset/export/export_folder.h"

/// One function and one source file a target. Each writes everything but export.json, and throws
/// std::runtime_error with one line. To add one: a name in export.cpp, a section in docs/formats.md, a reader
/// in tests/dataset/export.
namespace cps {

/// What a target needs to write a dataset.
struct ExportJob {
  const ExportSource& source;
  const ExportOptions& options;
  ExportFolder& folder;
  const ExportProgress& progress;
};

void export_webdataset(const ExportJob& job);
void export_huggingface(const ExportJob& job);
void export_colmap(const ExportJob& job);
void export_nerfstudio(const ExportJob& job);
void export_kitti(const ExportJob& job);
void export_coco(const ExportJob& job);

}  // namespace cps
