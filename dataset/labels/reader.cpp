#include "dataset/labels/reader.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// Subfolders of `folder`, sorted by name, without hidden ones.
std::vector<fs::path> subfolders(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_directory() && !entry.path().filename().string().starts_with('.'))
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

DatasetGroup read_group(const fs::path& folder, const fs::path& calibration, LensFamilies families) {
  const nlohmann::json json = read_json(calibration);
  if (families == LensFamilies::brown_conrady || !json.contains("params"))
    return {folder, label_from_json(json, calibration.string())};
  const ModelLabel model = model_label_from_json(json, calibration.string());
  return {folder, common_label(model), model};
}

}  // namespace

Dataset read_dataset(const fs::path& root, LensFamilies families) {
  if (!fs::is_directory(root)) throw std::runtime_error(root.string() + ": is not a folder; name a dataset");
  Dataset dataset{.root = root, .groups = {}, .images = {}};
  std::map<std::string, int> group_of_folder;
  for (const fs::path& set : subfolders(root))
    for (const fs::path& leaf : subfolders(set)) {
      const fs::path calibration = leaf / "calibration.json";
      if (!fs::exists(calibration)) continue;
      const fs::path folder = leaf.lexically_relative(root);
      group_of_folder[folder.string()] = static_cast<int>(dataset.groups.size());
      dataset.groups.push_back(read_group(folder, calibration, families));
    }
  if (dataset.groups.empty())
    throw std::runtime_error(root.string() + ": holds no <set>/<camera>_lens<number>/calibration.json");
  for (Part part : {Part::train, Part::val, Part::test}) {
    const fs::path list = root / "splits" / (to_string(part) + ".txt");
    std::istringstream lines(read_file(list));
    for (std::string line; std::getline(lines, line);) {
      const fs::path file(line);
      const auto group = group_of_folder.find(file.parent_path().string());
      if (group == group_of_folder.end())
        throw std::runtime_error(list.string() + ": " + line + ": lies in no folder with a calibration.json");
      dataset.images.push_back({file, group->second, part});
    }
  }
  return dataset;
}

}  // namespace cps
