#include "dataset/verify/verify_plan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "dataset/job/frames.h"
#include "dataset/labels/group_label.h"
#include "files/files.h"

namespace cps {
namespace {

/// How many fields stand before the first that was measured: those are the plan's.
std::size_t planned_fields(const std::string& header, const std::string& file) {
  const std::size_t end = header.find(",exposure,");
  if (end == header.npos) throw std::runtime_error(file + ": exposure: column is missing");
  return 1 + static_cast<std::size_t>(std::count(header.begin(), header.begin() + end, ','));
}

/// A line up to and without its `fields`-th comma outside quotes.
std::string first_fields(const std::string& line, std::size_t fields) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (line[i] == ',' && !is_quoted && --fields == 0) return line.substr(0, i);
  }
  return line;
}

/// The planned part of every line of a frames.csv. Throws std::runtime_error, `file` first, when its header
/// is none.
std::set<std::string> planned_lines(const std::string& csv, const std::string& file) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const std::size_t fields = planned_fields(line, file);
  std::set<std::string> planned;
  while (std::getline(lines, line)) planned.insert(first_fields(line, fields));
  return planned;
}

std::vector<std::string> group_faults(const std::filesystem::path& root, const Plan& plan, int g,
                                      const std::vector<const PlannedView*>& views) try {
  const PlannedGroup& group = plan.groups[g];
  std::vector<std::string> faults;
  const std::string label = (std::filesystem::path(group.folder) / "calibration.json").string();
  if (read_file(root / label) != to_json(group_label(plan, group)).dump(2) + "\n")
    faults.push_back(label + ": is not what the recipe gives");
  const ViewRecord record;
  std::vector<ImageRecord> images;
  images.reserve(views.size());
  std::vector<Frame> frames;
  for (const PlannedView* view : views) {
    images.push_back({.file = image_name(plan, *view), .sensor = {}, .sha256 = {}, .pixels_sha256 = {}});
    frames.push_back({view, &record, &images.back()});
  }
  const std::string csv = (std::filesystem::path(group.folder) / "frames.csv").string();
  const std::set<std::string> written = planned_lines(read_file(root / csv), csv);
  for (const std::string& line : planned_lines(frames_csv(frames), csv))
    if (!written.contains(line))
      faults.push_back(csv + ": " + line.substr(0, line.find(',')) + ": is not what the recipe gives");
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
