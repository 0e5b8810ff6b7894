#include "dataset/dense/dense_file.h"
#include "dataset/export/coco_categories.h"
#include "dataset/export/huggingface.h"
#include "dataset/export/instance_masks.h"
#include "dataset/export/sample_columns.h"
#include "dataset/export/scene_classes.h"

/// COCO's object detection format: annotations/instances_<part>.json, and the images of each part in a folder
/// of its own. An annotation is what one object shows of one class.
namespace cps {
namespace {

using Json = nlohmann::ordered_json;

Json info_json(const ExportSource& source) {
  Json info = {{"description", dataset_description(source)}};
  if (!source.credits.empty()) info["credits"] = source.credits;
  return info;
}

/// The image's number in the dataset, from 1: COCO's own evaluation takes an id of 0 for none.
std::int64_t id_of(const ExportSource& source, const DatasetImage& image) {
  return &image - source.dataset().images.data() + 1;
}

Json image_json(const ExportSource& source, const DatasetImage& image) {
  const Pinhole& camera = source.label_of(image).camera;
  return {{"id", id_of(source, image)},
          {"file_name", image.file.generic_string()},
          {"width", camera.width},
          {"height", camera.height},
          {"cps", sample_json(source, image)}};
}

/// COCO counts pixels from their corners: the box of a single pixel is one pixel wide.
Json annotation_json(const InstanceMask& mask, const Pinhole& camera) {
  const Eigen::Vector2i corner = mask.box.min(), size = mask.box.sizes() + Eigen::Vector2i::Ones();
  return {{"bbox", {corner.x(), corner.y(), size.x(), size.y()}},
          {"area", mask.area_px},
          {"iscrowd", 0},
          {"segmentation", {{"size", {camera.height, camera.width}}, {"counts", compressed_runs(mask.runs)}}},
          {"cps", {{"instance", mask.instance}}}};
}

/// A label of the image, after its file's hash was compared.
OIIO::ImageBuf pixels_of(const ExportSource& source, const DatasetImage& image, DenseLabel label) {
  read_dense_bytes(source, image, label);
  const std::filesystem::path file = source.dataset().root / dense_file(image.file, label);
  OIIO::ImageBuf pixels = read_dense(file, label);
  const Pinhole& camera = source.label_of(image).camera;
  if (pixels.spec().width != camera.width || pixels.spec().height != camera.height)
    throw std::runtime_error(file.string() + ": has another size than its image; cps verify says more");
  return pixels;
}

/// The category of what a mask shows; none where such things are not told apart.
std::optional<int> category_of(const ExportSource& source, const DatasetImage& image,
                               const CocoCategories& categories, int class_id) {
  const auto condition = static_cast<std::size_t>(source.frame_of(image).condition);
  if (condition >= categories.of_class.size())
    throw std::runtime_error(image.file.string() +
                             ": its condition is not in dataset.json; cps verify says more");
  const auto found = categories.of_class[condition].find(class_id);
  if (found == categories.of_class[condition].end())
    throw std::runtime_error(dense_file(image.file, DenseLabel::semantic).string() + ": has the class " +
                             std::to_string(class_id) + ", which dataset.json does not list for its scene");
  return found->second;
}

/// Appends the elements of a JSON list, one a line.
class JsonLines {
 public:
  explicit JsonLines(const Append& append) : append_(append) {}
  void add(const Json& json) {
    append_(separator_ + json.dump());
    separator_ = ",\n";
  }

 private:
  const Append& append_;
  std::string separator_ = "\n";
};

/// Links or copies the images of a part while it appends what they show.
void append_annotations(const ExportJob& job, Part part, const CocoCategories& categories,
                        const Append& append) {
  JsonLines lines(append);
  std::int64_t id = 0;
  for (const DatasetImage& image : job.source.images_of(part)) {
    const Pinhole& camera = job.source.label_of(image).camera;
    for (const InstanceMask& mask : instance_masks(pixels_of(job.source, image, DenseLabel::instance),
                                                   pixels_of(job.source, image, DenseLabel::semantic)))
      if (const std::optional<int> category = category_of(job.source, image, categories, mask.class_id)) {
        Json annotation = {{"id", ++id}, {"image_id", id_of(job.source, image)}, {"category_id", *category}};
        annotation.update(annotation_json(mask, camera));
        lines.add(annotation);
      }
    job.folder.add_image(job.source, image, to_string(part) / image.file);
    job.progress(1, image.file.string());
  }
}

ExportedFile write_annotations(const ExportJob& job, const std::string& name, Part part,
                               const CocoCategories& categories) {
  ExportedFile file = job.folder.write(name, [&](const Append& append) {
    append("{\"info\": " + info_json(job.source).dump() +
           ",\n\"licenses\": [],\n\"categories\": " + categories.list.dump() + ",\n\"images\": [");
    JsonLines lines(append);
    for (const DatasetImage& image : job.source.images_of(part)) lines.add(image_json(job.source, image));
    append(std::string("],\n\"annotations\": ["));
    append_annotations(job, part, categories, append);
    append(std::string("]}\n"));
  });
  file.samples = static_cast<std::int64_t>(job.source.images_of(part).size());
  return file;
}

}  // namespace

void export_coco(const ExportJob& job) {
  const CocoCategories categories = coco_categories(scene_classes(job.source));
  for (Part part : {Part::train, Part::val, Part::test}) {
    const std::string name = "annotations/instances_" + to_string(part) + ".json";
    if (const std::optional<ExportedFile> kept = job.folder.kept(name)) {
      for (const DatasetImage& image : job.source.images_of(part))
        job.folder.add_image(job.source, image, to_string(part) / image.file);
      job.progress(kept->samples, name);
    } else {
      job.folder.record(write_annotations(job, name, part, categories));
    }
  }
}

}  // namespace cps
