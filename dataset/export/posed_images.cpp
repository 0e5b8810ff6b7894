#include "dataset/export/posed_images.h"

#include <fmt/format.h>

namespace cps {

std::map<std::int64_t, std::vector<const DatasetImage*>> images_by_condition(const ExportSource& source) {
  std::map<std::int64_t, std::vector<const DatasetImage*>> images;
  for (const DatasetImage& image : source.dataset().images)
    images[source.frame_of(image).condition].push_back(&image);
  return images;
}

std::string condition_folder(std::int64_t condition) {
  return fmt::format("condition_{:03}", condition);
}

void add_condition_images(const ExportJob& job, const std::string& folder,
                          const std::vector<const DatasetImage*>& images) {
  for (const DatasetImage* image : images) {
    job.folder.add_image(job.source, *image, folder / ("images" / image->file));
    job.progress(1, image->file.string());
  }
}

CalibratedCamera calibrated_camera(const Label& label, const std::string& name) {
  return {.name = name, .pinhole = label.camera, .distortion = label.distortion};
}

}  // namespace cps
