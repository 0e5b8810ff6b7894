#include "production/dense_labels.h"

#include <algorithm>

#include "dataset/dense/bearings.h"
#include "dataset/dense/dense_file.h"
#include "files/files.h"
#include "numbers/cpu_time.h"
#include "production/each_image.h"
#include "production/view_render.h"
#include "renderer/aov.h"
#include "scenes/classes/semantic_classes.h"
#include "scenes/rig.h"

namespace cps {
namespace {

/// The layer whose rays a label needs.
Aov aov_of(DenseLabel label) {
  switch (label) {
    case DenseLabel::depth:
      return Aov::depth;
    case DenseLabel::distance:
      return Aov::distance;
    case DenseLabel::normal:
      return Aov::normal;
    default:
      return Aov::instance;
  }
}

/// Each layer once, in the labels' order.
std::vector<Aov> layers_for(const std::vector<DenseLabel>& labels) {
  std::vector<Aov> layers;
  for (const DenseLabel label : labels)
    if (needs_scene(label) && std::ranges::find(layers, aov_of(label)) == layers.end())
      layers.push_back(aov_of(label));
  return layers;
}

/// Turns vectors of the world to the camera's frame.
void turn_to_camera(OIIO::ImageBuf& vectors, const Camera& camera) {
  const Eigen::Matrix3d camera_from_world = camera.world_from_camera.linear().transpose();
  Eigen::Map<Eigen::Matrix3Xf> columns(static_cast<float*>(vectors.localpixels()), 3,
                                       static_cast<Eigen::Index>(vectors.spec().image_pixels()));
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    columns.col(i) = (camera_from_world * columns.col(i).cast<double>()).cast<float>();
}

/// 16-bit pixels from instance ids (0: nothing): an entry of the table, or the background.
OIIO::ImageBuf looked_up(const OIIO::ImageBuf& ids, const std::vector<std::uint16_t>& table,
                         std::uint16_t background) {
  OIIO::ImageSpec spec = ids.spec();
  spec.set_format(OIIO::TypeDesc::UINT16);
  spec.channelnames = {"Y"};
  OIIO::ImageBuf values(spec);
  const auto* id = static_cast<const std::uint32_t*>(ids.localpixels());
  auto* value = static_cast<std::uint16_t*>(values.localpixels());
  for (std::size_t i = 0; i < spec.image_pixels(); ++i) value[i] = id[i] == 0 ? background : table[id[i] - 1];
  return values;
}

/// An image's camera with the layers that rays of its pixels' centres gave.
struct SeenImage {
  Camera camera;
  std::vector<Aov> aovs;
  std::vector<ImageLayer> layers = {};  ///< parallel to aovs

  const OIIO::ImageBuf& layer(DenseLabel label) const {
    const auto found = std::ranges::find(aovs, aov_of(label));
    return layers[static_cast<std::size_t>(found - aovs.begin())].image;
  }
};

/// `rays`, `up` or `latitude`.
OIIO::ImageBuf bearing_of(DenseLabel label, const SeenImage& seen) {
  return bearing_label(ModelCamera{{}, seen.camera.pinhole, *seen.camera.lens},
                       gravity_in_camera(seen.camera.world_from_camera.linear()), label);
}

/// Classes, with 0 where the lens shows nothing, not even the sky.
OIIO::ImageBuf classes_of_pixels(const SeenImage& seen, const InstanceLabels& meaning) {
  OIIO::ImageBuf classes =
      looked_up(seen.layer(DenseLabel::semantic), meaning.semantic, meaning.semantic_background);
  if (std::holds_alternative<Distortion>(*seen.camera.lens)) return classes;
  const OIIO::ImageBuf rays = bearing_of(DenseLabel::rays, seen);
  const auto* ray = static_cast<const float*>(rays.localpixels());
  auto* value = static_cast<std::uint16_t*>(classes.localpixels());
  for (std::size_t i = 0; i < classes.spec().image_pixels(); ++i)
    if (ray[3 * i] == 0 && ray[3 * i + 1] == 0 && ray[3 * i + 2] == 0) value[i] = 0;
  return classes;
}

OIIO::ImageBuf pixels_of(DenseLabel label, const SeenImage& seen, const InstanceLabels& meaning) {
  switch (label) {
    case DenseLabel::depth:
    case DenseLabel::distance:
      return seen.layer(label);
    case DenseLabel::normal: {
      OIIO::ImageBuf normals = seen.layer(label);
      turn_to_camera(normals, seen.camera);
      return normals;
    }
    case DenseLabel::instance:
      return looked_up(seen.layer(label), meaning.object, 0);
    case DenseLabel::semantic:
      return classes_of_pixels(seen, meaning);
    default:
      return bearing_of(label, seen);
  }
}

std::vector<DenseRecord> label_image(const Recipe& recipe, const PlannedImage& image, const PlannedView& view,
                                     const LitScene& lit, const std::filesystem::path& root) {
  const ModelCamera camera = image.camera();
  SeenImage seen{.camera = camera_of(view, camera.pinhole), .aovs = layers_for(recipe.labels)};
  seen.camera.lens = camera.lens;
  if (!seen.aovs.empty()) seen.layers = render_aovs(*lit.scene, seen.camera, {}, seen.aovs);
  std::vector<DenseRecord> records;
  for (const DenseLabel label : recipe.labels) {
    const std::string bytes = encode_dense(pixels_of(label, seen, lit.labels), label);
    write_file(root / dense_file(image.file, label), bytes);
    records.push_back({.label = label, .bytes = bytes.size(), .sha256 = sha256(bytes)});
  }
  return records;
}

}  // namespace

InstanceLabels instance_labels(const Scene& scene, const std::vector<DenseLabel>& wanted) {
  InstanceLabels labels;
  if (std::ranges::count(wanted, DenseLabel::instance) > 0) labels.object = object_ids(scene);
  if (std::ranges::count(wanted, DenseLabel::semantic) > 0) {
    SceneClasses classes = semantic_classes(scene);
    labels.semantic = std::move(classes.of_instance);
    labels.semantic_background = classes.background;
  }
  return labels;
}

std::vector<std::vector<DenseRecord>> make_dense_labels(const Recipe& recipe, const PlannedView& view,
                                                        const ViewImages& wanted, const LitScene& lit,
                                                        const std::filesystem::path& root,
                                                        std::atomic<std::int64_t>& cpu_ns) {
  std::vector<std::vector<DenseRecord>> records(wanted.images.size());
  if (recipe.labels.empty()) return records;
  for_each_image(wanted.images.size(), [&](std::size_t i) {
    const double begin_s = cpu_s(CLOCK_THREAD_CPUTIME_ID);
    records[i] = label_image(recipe, wanted.images[i], view, lit, root);
    cpu_ns += static_cast<std::int64_t>(1e9 * (cpu_s(CLOCK_THREAD_CPUTIME_ID) - begin_s));
  });
  return records;
}

}  // namespace cps
