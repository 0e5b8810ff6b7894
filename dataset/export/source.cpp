#include "dataset/export/source.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string_view>
#include <unordered_set>

#include "dataset/dense/dense_file.h"
#include "files/files.h"
#include "files/pieces.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// The files that together say everything about the dataset, in an order of their own.
std::string hash_of_tables(const DatasetFiles& files) {
  const fs::path& root = files.dataset.root;
  Sha256 hash;
  const auto add = [&](const fs::path& file) {
    hash.add(file.generic_string() + " " + sha256(read_file(root / file)) + "\n");
  };
  if (files.description) add("dataset.json");
  for (Part part : {Part::train, Part::val, Part::test}) add("splits/" + to_string(part) + ".txt");
  for (const DatasetGroup& group : files.dataset.groups) {
    add(group.folder / "calibration.json");
    if (files.description) add(group.folder / "frames.csv");
  }
  return hash.hex();
}

std::string credits_of(const DatasetFiles& files) {
  std::set<std::string> credits;
  for (const nlohmann::json& scene : files.list("scenes"))
    if (std::string credit = scene.value("credits", ""); !credit.empty()) credits.insert(std::move(credit));
  std::string text;
  for (const std::string& credit : credits) text += credit + "\n";
  return text;
}

std::vector<DenseLabel> labels_of(const FrameRow& frame) {
  std::vector<DenseLabel> labels;
  for (const DenseHash& dense : frame.dense) labels.push_back(dense.label);
  return labels;
}

void check_lists(const DatasetFiles& files) {
  std::unordered_set<std::string_view> listed;
  for (const DatasetImage& image : files.dataset.images) {
    const auto fail = [&](const char* what) { throw std::runtime_error(image.file.string() + ": " + what); };
    if (!listed.insert(image.file.native()).second)
      fail("stands in the split lists twice; cps verify says more");
    if (files.description && !files.frame_of(image.file)) fail("is not in frames.csv; cps verify says more");
  }
  if (files.dataset.images.empty())
    throw std::runtime_error(files.dataset.root.string() + ": its split lists are empty: nothing to export");
}

/// The dense labels that all images have. The lists must have been checked.
std::vector<DenseLabel> common_dense_labels(const DatasetFiles& files) {
  if (!files.description) return {};
  const std::vector<DatasetImage>& images = files.dataset.images;
  std::vector<DenseLabel> labels = labels_of(*files.frame_of(images.front().file));
  for (const DatasetImage& image : images)
    if (labels_of(*files.frame_of(image.file)) != labels)
      throw std::runtime_error(
          image.file.string() +
          ": has not the dense labels of other images, as frames.csv says; cps verify says more");
  return labels;
}

/// The bytes of a file whose hash frames.csv may tell.
std::string read_checked(const fs::path& file, const std::optional<std::string>& wanted_sha256) {
  std::string bytes = read_file(file);
  if (wanted_sha256 && sha256(bytes) != *wanted_sha256)
    throw std::runtime_error(file.string() + ": its hash is not that in frames.csv; cps verify says more");
  return bytes;
}

}  // namespace

bool ExportSource::has(DenseLabel label) const {
  return std::ranges::count(dense_labels, label) > 0;
}

std::span<const DatasetImage> ExportSource::images_of(Part part) const {
  const auto range = std::ranges::equal_range(dataset().images, part, {}, &DatasetImage::part);
  return {range.begin(), range.end()};
}

ExportSource read_export_source(const fs::path& root) try {
  Faults faults;
  ExportSource source{.files = read_dataset_files(root, faults),
                      .name = "cps",
                      .credits = {},
                      .sha256 = {},
                      .dense_labels = {}};
  if (!faults.empty()) throw std::runtime_error(faults.front());
  check_lists(source.files);
  source.dense_labels = common_dense_labels(source.files);
  if (source.files.description) source.name = source.files.description->value("name", source.name);
  source.credits = credits_of(source.files);
  source.sha256 = hash_of_tables(source.files);
  return source;
} catch (const nlohmann::json::exception& error) {
  throw std::runtime_error((root / "dataset.json").string() + ": " + error.what());
}

std::string read_image(const ExportSource& source, const DatasetImage& image) {
  std::optional<std::string> wanted;
  if (source.has_frames()) wanted = source.frame_of(image).sha256;
  return read_checked(source.dataset().root / image.file, wanted);
}

std::string read_dense_bytes(const ExportSource& source, const DatasetImage& image, DenseLabel label) {
  const auto hash = std::ranges::find(source.frame_of(image).dense, label, &DenseHash::label);
  return read_checked(source.dataset().root / dense_file(image.file, label), hash->sha256);
}

}  // namespace cps
