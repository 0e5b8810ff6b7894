#include "dataset/export/huggingface.h"

#include "dataset/dense/dense_file.h"
#include "dataset/export/sample_columns.h"
#include "dataset/export/scene_classes.h"
#include "files/files.h"

/// Hugging Face's ImageFolder: a folder per split with its images and metadata.jsonl, README.md as dataset
/// card, and croissant.json. Dense labels lie in a folder of their own: ImageFolder would take those of them
/// that are PNGs for images.
namespace cps {
namespace {

namespace fs = std::filesystem;

ExportedFile write_metadata(const ExportJob& job, Part part) {
  const std::span<const DatasetImage> images = job.source.images_of(part);
  ExportedFile file = job.folder.write(to_string(part) + "/metadata.jsonl", [&](const Append& append) {
    for (const DatasetImage& image : images) append(metadata_line(job.source, image));
  });
  file.samples = static_cast<std::int64_t>(images.size());
  return file;
}

}  // namespace

void export_huggingface(const ExportJob& job) {
  if (job.source.has(DenseLabel::semantic))
    write_json(job.folder.at("dense/classes.json"), scene_classes(job.source));
  std::vector<HuggingFaceSplit> splits;
  for (Part part : {Part::train, Part::val, Part::test}) {
    const std::span<const DatasetImage> images = job.source.images_of(part);
    if (images.empty()) continue;  // a split without files cannot be loaded
    for (const DatasetImage& image : images) {
      job.folder.add_image(job.source, image, to_string(part) / image.file);
      for (DenseLabel label : job.source.dense_labels)
        job.folder.add_dense(job.source, image, label,
                             fs::path("dense") / to_string(part) / dense_file(image.file, label));
      job.progress(1, image.file.string());
    }
    splits.push_back({to_string(part), write_metadata(job, part), images.front().file.extension().string()});
  }
  write_file(job.folder.at("README.md"), dataset_card(job, splits));
  write_json(job.folder.at("croissant.json"), croissant(job, splits));
}

}  // namespace cps
