#include "dataset/verify/dense_check.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dataset/dense/bearings.h"
#include "dataset/dense/dense_file.h"
#include "dataset/job/recipe_json.h"
#include "dataset/verify/class_check.h"
#include "files/files.h"

namespace cps {
namespace {

/// Of two floats that were computed in other ways.
constexpr double agreement = 1e-5;

/// One image's labels while they are checked.
struct LabelledImage {
  const DatasetFiles& files;
  const DatasetImage& image;
  const FrameRow& frame;

  const Label& label() const { return files.dataset.groups[image.group].label; }
  std::filesystem::path file_of(DenseLabel kind) const {
    return files.dataset.root / dense_file(image.file, kind);
  }
  OIIO::ImageBuf bearing(DenseLabel kind) const {
    return bearing_label(files.dataset.groups[image.group].camera(), frame.gravity, kind);
  }
};

std::size_t value_count(const OIIO::ImageBuf& image) {
  return image.spec().image_pixels() * static_cast<std::size_t>(image.nchannels());
}

const float* floats(const OIIO::ImageBuf& image) {
  return static_cast<const float*>(image.localpixels());
}

bool agree(const OIIO::ImageBuf& found, const OIIO::ImageBuf& expected) {
  const float *a = floats(found), *b = floats(expected);
  for (std::size_t i = 0; i < value_count(found); ++i)
    if (!(std::abs(a[i] - b[i]) <= agreement * std::max(1.0f, std::abs(b[i])))) return false;
  return true;
}

/// Depth is the distance's part along the optical axis.
bool is_depth_of(const OIIO::ImageBuf& depth, const OIIO::ImageBuf& distance, const OIIO::ImageBuf& rays) {
  const float *z = floats(depth), *d = floats(distance), *ray = floats(rays);
  for (std::size_t i = 0; i < value_count(depth); ++i) {
    if (std::isinf(z[i]) && std::isinf(d[i])) continue;
    if (!(std::abs(z[i] - d[i] * ray[3 * i + 2]) <= agreement * d[i])) return false;
  }
  return true;
}

/// Normals are unit vectors, or 0 where nothing was hit.
bool are_normals(const OIIO::ImageBuf& normals) {
  const float* n = floats(normals);
  for (std::size_t i = 0; i < value_count(normals); i += 3) {
    const double squares = double(n[i]) * n[i] + double(n[i + 1]) * n[i + 1] + double(n[i + 2]) * n[i + 2];
    if (squares != 0 && !(std::abs(squares - 1) <= agreement)) return false;
  }
  return true;
}

/// Empty when the pixels of a label are what can be known of them.
std::string pixels_fault(const LabelledImage& image, DenseLabel kind, const OIIO::ImageBuf& pixels) {
  switch (kind) {
    case DenseLabel::rays:
    case DenseLabel::up:
    case DenseLabel::latitude:
      return agree(pixels, image.bearing(kind)) ? ""
                                                : "contradicts calibration.json and the pose in frames.csv";
    case DenseLabel::depth: {
      const std::filesystem::path distance = image.file_of(DenseLabel::distance);
      if (!std::filesystem::exists(distance)) return "";
      return is_depth_of(pixels, read_dense(distance, DenseLabel::distance), image.bearing(DenseLabel::rays))
                 ? ""
                 : "contradicts the label distance";
    }
    case DenseLabel::normal:
      return are_normals(pixels) ? "" : "holds normals that are no unit vectors";
    case DenseLabel::semantic:
      return has_known_classes(image.files, image.frame, pixels)
                 ? ""
                 : "holds a class that its scene in dataset.json does not list";
    case DenseLabel::distance:
    case DenseLabel::instance:
      return "";
  }
  return "";
}

std::string file_fault(const LabelledImage& image, const DenseHash& dense) try {
  const std::filesystem::path file = image.file_of(dense.label);
  if (sha256(read_file(file)) != dense.sha256)
    return fmt::format("its bytes do not match {}_sha256 in frames.csv", to_string(dense.label));
  const OIIO::ImageBuf pixels = read_dense(file, dense.label);
  const Pinhole& camera = image.label().camera;
  if (pixels.spec().width != camera.width || pixels.spec().height != camera.height)
    return "its size contradicts calibration.json";
  return pixels_fault(image, dense.label, pixels);
} catch (const std::runtime_error& error) {
  return error.what();
}

Faults image_faults(const LabelledImage& image, const std::vector<DenseLabel>& wanted) {
  Faults faults;
  for (const DenseLabel kind : wanted) {
    const std::string file = dense_file(image.image.file, kind).string();
    const auto dense = std::ranges::find(image.frame.dense, kind, &DenseHash::label);
    const std::string fault = dense == image.frame.dense.end()
                                  ? fmt::format("frames.csv has no {}_sha256", to_string(kind))
                                  : file_fault(image, *dense);
    if (!fault.empty()) faults.push_back(file + ": " + fault);
  }
  return faults;
}

}  // namespace

std::int64_t check_dense(const DatasetFiles& files, Faults& faults) try {
  const Dataset& dataset = files.dataset;
  const std::vector<DenseLabel> wanted =
      files.description ? read_recipe(dataset.root).labels : std::vector<DenseLabel>{};
  std::set<std::string> expected;
  for (const DatasetImage& image : dataset.images)
    for (const DenseLabel kind : wanted) expected.insert(dense_file(image.file, kind).string());
  for (const std::string& file : files.dense)
    if (!expected.contains(file))
      faults.push_back(file + ": is a dense label that the dataset does not have");

  std::vector<Faults> found(wanted.empty() ? 0 : dataset.images.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    const DatasetImage& image = dataset.images[i];
    if (const FrameRow* frame = files.frame_of(image.file))
      found[i] = image_faults({files, image, *frame}, wanted);
  });
  for (const Faults& of_image : found) faults.insert(faults.end(), of_image.begin(), of_image.end());
  return static_cast<std::int64_t>(expected.size());
} catch (const std::runtime_error&) {  // the recipe in dataset.json cannot be read: check_poses() says so
  return 0;
}

}  // namespace cps
