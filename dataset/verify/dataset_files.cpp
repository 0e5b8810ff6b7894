#include "dataset/verify/dataset_files.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dataset/dense/dense_file.h"
#include "dataset/job/finish.h"
#include "dataset/job/job.h"
#include "dataset/labels/valid_mask.h"
#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

bool is_image(const fs::path& file, const DatasetGroup& group) {
  if (group.model && file.filename() == valid_mask_file) return false;
  return file.extension() != ".csv" && file.extension() != ".json";
}

/// Whether dataset.json is that of cps generate. That of cps relens has no recipe.
bool is_record(const nlohmann::json& description) {
  return description.contains("recipe") || description.value("is_cps", true);
}

bool has_frames(const Dataset& dataset) {
  return std::ranges::any_of(dataset.groups, [&](const DatasetGroup& group) {
    return fs::exists(dataset.root / group.folder / "frames.csv");
  });
}

void read_frames(DatasetFiles& files, std::size_t group, Faults& faults) try {
  const fs::path& folder = files.dataset.groups[group].folder;
  for (FrameRow& row : read_frames_csv(files.dataset.root / folder / "frames.csv")) {
    const std::string file = (folder / row.file).string();
    if (!files.frames.try_emplace(file, std::move(row)).second)
      faults.push_back(file + ": stands in frames.csv twice");
  }
} catch (const std::runtime_error& error) {
  faults.push_back(error.what());
  files.unreadable.insert(group);
}

}  // namespace

const FrameRow* DatasetFiles::frame_of(const fs::path& image) const {
  const auto found = frames.find(image.string());
  return found == frames.end() ? nullptr : &found->second;
}

nlohmann::json DatasetFiles::list(const char* key) const {
  return description ? description->value(key, nlohmann::json::array()) : nlohmann::json::array();
}

std::string streets_of(const nlohmann::json& scenes, const nlohmann::json& condition) {
  const std::string file = condition.value("scene", "");
  for (const auto& scene : scenes)
    if (scene.value("file", "") == file && scene.contains("city"))
      return "city " + scene["city"].value("style", "") + " " +
             scene["city"].value("seed", nlohmann::json(0)).dump();
  return file;
}

DatasetFiles open_dataset(const fs::path& root, LensFamilies families) {
  if (!is_finished(root) && has_job(root))
    throw std::runtime_error(
        root.string() + ": has no dataset.json: it is not finished; run cps generate again, or cps finish");
  DatasetFiles files{.dataset = read_dataset(root, families)};
  if (is_finished(root)) {
    nlohmann::json description = read_json(root / "dataset.json");
    if (is_record(description)) files.description = std::move(description);
  }
  if (!files.description && has_frames(files.dataset))
    throw std::runtime_error((root / "dataset.json").string() +
                             ": is missing: copy it from where the dataset comes from");
  return files;
}

DatasetFiles read_dataset_files(const fs::path& root, Faults& faults, LensFamilies families) {
  DatasetFiles files = open_dataset(root, families);
  for (std::size_t g = 0; g < files.dataset.groups.size(); ++g) {
    if (files.description) read_frames(files, g, faults);
    const DatasetGroup& group = files.dataset.groups[g];
    const fs::path& folder = group.folder;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder))
      if (is_image(entry.path(), group))
        (is_dense_file(entry.path()) ? files.dense : files.images)
            .insert((folder / entry.path().filename()).string());
  }
  return files;
}

}  // namespace cps
