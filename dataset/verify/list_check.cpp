#include "dataset/verify/list_check.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace cps {
namespace {

/// The files that the split lists name.
std::set<std::string> check_listed(const DatasetFiles& files, Faults& faults) {
  std::set<std::string> listed;
  for (const DatasetImage& image : files.dataset.images) {
    const std::string file = image.file.string();
    const auto fault = [&](const std::string& what) { faults.push_back(file + ": " + what); };
    if (!listed.insert(file).second) fault("stands in the split lists twice");
    if (const Part part = files.dataset.groups[image.group].label.part;
        part != Part::all && part != image.part)
      fault("is listed in " + to_string(image.part) + ", but its lens belongs to " + to_string(part));
    if (!files.description || files.unreadable.contains(static_cast<std::size_t>(image.group))) continue;
    if (const FrameRow* frame = files.frame_of(image.file); !frame)
      fault("is not in frames.csv");
    else if (frame->part != image.part)
      fault("is listed in " + to_string(image.part) + ", but frames.csv says " + to_string(frame->part));
  }
  return listed;
}

}  // namespace

void check_lists(const DatasetFiles& files, Faults& faults) {
  const std::set<std::string> listed = check_listed(files, faults);
  for (const auto& [file, frame] : files.frames)
    if (!listed.contains(file)) faults.push_back(file + ": stands in no split list");
  for (const std::string& file : files.images) {
    if (files.description && !files.frames.contains(file) && !listed.contains(file))
      faults.push_back(file + ": is not in frames.csv");
    if (!files.description && !listed.contains(file)) faults.push_back(file + ": stands in no split list");
  }
  if (!files.description) return;
  const std::int64_t expected = files.description->value("images", std::int64_t{-1});
  if (expected != static_cast<std::int64_t>(files.dataset.images.size()))
    faults.push_back(fmt::format("dataset.json: images: says {}, the lists hold {}", expected,
                                 files.dataset.images.size()));
}

void check_streets(const DatasetFiles& files, Faults& faults) {
  if (!files.description) return;
  const auto recipe = files.description->value("recipe", nlohmann::json::object());
  if (recipe.value("split", "route") == "thesis") return;
  const nlohmann::json scenes = files.list("scenes");
  std::vector<std::string> streets;  // by condition
  for (const auto& condition : files.list("conditions")) streets.push_back(streets_of(scenes, condition));
  std::map<std::pair<std::string, std::string>, Part> part_of_street;
  for (const auto& [file, frame] : files.frames) {
    if (frame.condition >= static_cast<std::int64_t>(streets.size())) {
      faults.push_back(fmt::format("{}: condition {} is not in dataset.json", file, frame.condition));
      continue;
    }
    const auto [known, is_new] =
        part_of_street.try_emplace({streets[frame.condition], frame.street}, frame.part);
    if (!is_new && known->second != frame.part)
      faults.push_back(file + ": street " + frame.street + " occurs in " + to_string(known->second) +
                       " and " + to_string(frame.part));
  }
}

}  // namespace cps
