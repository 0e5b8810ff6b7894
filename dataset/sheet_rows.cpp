#include "dataset/sheet_rows.h"

#include <algorithm>
#include <map>

namespace cps {

std::vector<SheetRow> choose_sheet_rows(const Dataset& dataset, int rows_per_set, int columns) {
  std::map<std::string, std::map<std::string, SheetRow>> views_of_set;
  for (const DatasetImage& image : dataset.images) {
    const std::string set = dataset.groups[image.group].folder.parent_path().string();
    views_of_set[set][image.file.filename().string()].push_back(&image);
  }
  std::vector<SheetRow> chosen;
  for (auto& [set, views] : views_of_set) {
    const auto count = std::min<std::size_t>(rows_per_set, views.size());
    for (std::size_t i = 0; i < count; ++i) {
      SheetRow row = std::next(views.begin(), static_cast<std::ptrdiff_t>(i * views.size() / count))->second;
      std::sort(row.begin(), row.end(), [](const auto* a, const auto* b) { return a->file < b->file; });
      row.resize(std::min<std::size_t>(row.size(), columns));
      chosen.push_back(std::move(row));
    }
  }
  return chosen;
}

}  // namespace cps
