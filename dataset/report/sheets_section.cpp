#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>

#include "dataset/pixels/thumbnail.h"
#include "dataset/report/label_distributions.h"
#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "dataset/sheet_rows.h"
#include "files/data_uri.h"
#include "files/markup.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr std::size_t max_thumbnail_bytes = 24'000, max_bytes = 3'600'000;

/// The folder of a row's set.
std::string set_of(const Dataset& dataset, const SheetRow& row) {
  return dataset.groups[row.front()->group].folder.parent_path().string();
}

/// The rows that the options allow: as many of each set, and, where not even one of each fits, of some sets.
std::vector<SheetRow> chosen_rows(const Dataset& dataset, const ReportOptions& options) {
  if (options.thumbnails == 0 || dataset.images.empty()) return {};
  const int columns = std::min(options.columns, options.thumbnails);
  const auto max_rows = static_cast<std::size_t>(options.thumbnails / columns);
  std::vector<SheetRow> first = choose_sheet_rows(dataset, 1, columns);  // a row per set
  if (first.size() <= max_rows) {
    const auto rows = std::min(max_rows / first.size(), static_cast<std::size_t>(options.rows_per_set));
    return choose_sheet_rows(dataset, static_cast<int>(rows), columns);
  }
  std::vector<SheetRow> some;
  for (std::size_t i = 0; i < max_rows; ++i) some.push_back(std::move(first[i * first.size() / max_rows]));
  return some;
}

std::string thumbnail_uri(const Dataset& dataset, const DatasetImage& image, const ReportOptions& options) {
  const Pinhole& camera = dataset.groups[image.group].label.camera;
  // The longer side counts, so that tall images take no more room than wide ones.
  const double scale =
      static_cast<double>(options.thumbnail_width_px) / std::max(camera.width, camera.height);
  const ImageSize size = {std::max(1, static_cast<int>(scale * camera.width)),
                          std::max(1, static_cast<int>(scale * camera.height))};
  const std::size_t share = max_bytes / static_cast<std::size_t>(options.thumbnails);
  return data_uri("image/jpeg", encode_thumbnail(thumbnail(dataset.root / image.file, size),
                                                 std::min(max_thumbnail_bytes, share)));
}

std::string lens_numbers(const Label& label) {
  std::string text = fmt::format("H-FOV {:.2f}°", degrees(hfov_rad(label.camera)));
  if (is_undistorted(label)) return text + ", no lens";
  const Distortion& lens = label.distortion;
  return text + fmt::format("<br>k {:+.4g} {:+.4g} {:+.4g}<br>p {:+.3g} {:+.3g}<br>c {:.1f} {:.1f} px",
                            lens.k1, lens.k2, lens.k3, lens.p1, lens.p2, label.camera.cx, label.camera.cy);
}

/// The group's name; if it has a lens, a link that draws it.
std::string group_name(const DatasetGroup& group) {
  const std::string name = clipped(group.folder.filename().string(), 100);
  if (is_undistorted(group.label)) return name;
  return "<a href=\"#lens=" + escaped(group.folder.string()) + "\">" + name + "</a>";
}

std::string figure(const Dataset& dataset, const DatasetImage& image, const std::string& uri) {
  const DatasetGroup& group = dataset.groups[image.group];
  return fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}, {}<br>{}</figcaption></figure>\n",
                     uri, escaped(image.file.string()), group_name(group), to_string(image.part),
                     lens_numbers(group.label));
}

}  // namespace

std::string sheets_section(const DatasetSurvey& survey, const ReportOptions& options) {
  const Dataset& dataset = survey.files.dataset;
  const std::vector<SheetRow> rows = chosen_rows(dataset, options);
  std::vector<const DatasetImage*> images;
  for (const SheetRow& row : rows) images.insert(images.end(), row.begin(), row.end());
  std::vector<std::string> figures(images.size());
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    figures[i] = figure(dataset, *images[i], thumbnail_uri(dataset, *images[i], options));
  });
  std::string html = "<section id=\"sheets\"><h2>Contact sheets</h2>\n";
  html += fmt::format("<p>{} of {} images: views evenly spread over each set, a row per view.</p>\n",
                      images.size(), grouped(static_cast<std::int64_t>(dataset.images.size())));
  std::size_t i = 0;
  std::string set;
  for (const SheetRow& row : rows) {
    if (set_of(dataset, row) != set) {
      set = set_of(dataset, row);
      html += "<h3>" + clipped(set, 100) + "</h3>\n";
    }
    html += "<div class=\"view\">\n";
    for (std::size_t k = 0; k < row.size(); ++k) html += figures[i++];
    html += "</div>\n";
  }
  return html + "</section>\n";
}

}  // namespace cps
