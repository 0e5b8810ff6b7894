#include "dataset/verify/verify_plan.h"

#include <tbb/parallel_for.h>

#include <map>
#include <optional>
#include <stdexcept>

#include "dataset/job/frames.h"
#include "dataset/labels/group_label.h"
#include "dataset/labels/valid_mask.h"
#include "files/files.h"

namespace cps {
namespace {

/// The columns that the plan decides and that differ between two rows, by name; empty when none does.
std::string differing_columns(const CsvTable& planned, std::size_t planned_row, const CsvTable& written,
                              std::size_t written_row) {
  std::string names;
  for (const FrameColumn& column : frame_columns()) {
    const std::optional<std::size_t> place = find_column(written, column);
    if (!column.is_planned || !place) continue;
    if (planned.at(planned_row, planned.column(column.name)).text() != written.at(written_row, *place).text())
      names += (names.empty() ? "" : ", ") + std::string(column.name);
  }
  return names;
}

/// Compares a leaf folder's frames.csv with the rows that the plan gives. `file` is for the faults.
std::vector<std::string> frames_faults(const CsvTable& planned, const CsvTable& written,
                                       const std::string& file) {
  std::map<std::string, std::size_t> written_rows;  // by image
  const std::size_t name = written.column("file"), planned_name = planned.column("file");
  for (std::size_t r = 0; r < written.rows.size(); ++r) written_rows[written.at(r, name).text()] = r;
  std::vector<std::string> faults;
  for (std::size_t r = 0; r < planned.rows.size(); ++r) {
    const std::string& image = planned.at(r, planned_name).text();
    const auto found = written_rows.find(image);
    if (found == written_rows.end()) {
      faults.push_back(file + ": " + image + ": is missing, but the recipe gives it");
      continue;
    }
    if (const std::string names = differing_columns(planned, r, written, found->second); !names.empty())
      faults.push_back(file + ": " + image + ": " + names + ": is not what the recipe gives");
  }
  return faults;
}

/// Whether the file holds the group's label, in the form of any schema.
bool is_label(const std::filesystem::path& file, const Plan& plan, const PlannedGroup& group) {
  const std::string text = read_file(file);
  const auto is_text = [&](const nlohmann::ordered_json& json) { return text == json.dump(2) + "\n"; };
  if (group.model)
    return is_text(to_json(group_model_label(plan, group, valid_mask(*group.model).has_value())));
  const Label label = group_label(plan, group);
  for (int schema = 1; schema <= label_schema; ++schema)
    if (is_text(to_json(label, schema))) return true;
  return false;
}

std::vector<std::string> group_faults(const std::filesystem::path& root, const Plan& plan, int g,
                                      const std::vector<const PlannedView*>& views) try {
  const PlannedGroup& group = plan.groups[g];
  std::vector<std::string> faults;
  const std::string label = (std::filesystem::path(group.folder) / "calibration.json").string();
  if (!is_label(root / label, plan, group)) faults.push_back(label + ": is not what the recipe gives");
  const ViewRecord record;
  std::vector<ImageRecord> images;
  images.reserve(views.size());
  std::vector<Frame> frames;
  for (const PlannedView* view : views) {
    images.push_back({.file = image_name(plan, *view), .sensor = {}, .sha256 = {}, .pixels_sha256 = {}});
    frames.push_back({view, &record, &images.back()});
  }
  const std::string csv = (std::filesystem::path(group.folder) / "frames.csv").string();
  for (std::string& fault :
       frames_faults(parse_csv(frames_csv(frames), csv), parse_csv(read_file(root / csv), csv), csv))
    faults.push_back(std::move(fault));
  return faults;
} catch (const std::runtime_error& error) {
  return {error.what()};
}

}  // namespace

std::vector<std::string> faults_against_plan(const std::filesystem::path& root, const Plan& plan) {
  std::vector<std::vector<const PlannedView*>> views_of(plan.groups.size());
  for (const PlannedView& view : plan.views)
    for (int g : view.groups) views_of[g].push_back(&view);
  std::vector<std::vector<std::string>> faults(plan.groups.size());
  tbb::parallel_for(std::size_t{0}, plan.groups.size(), [&](std::size_t g) {
    faults[g] = group_faults(root, plan, static_cast<int>(g), views_of[g]);
  });
  std::vector<std::string> all;
  for (const auto& of_group : faults) all.insert(all.end(), of_group.begin(), of_group.end());
  return all;
}

}  // namespace cps
