#include "dataset/contact_sheet.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "dataset/pixels/thumbnail.h"
#include "dataset/sheet_rows.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr int gap_px = 6;

/// Captions of three lines, sized so that the longest line just fits below a tile.
struct Captions {
  int text_px, line_px, height_px;
  explicit Captions(int tile_width_px)
      : text_px(std::clamp(tile_width_px / 33, 6, 24)), line_px(text_px + 3), height_px(3 * line_px + 4) {}
};

int tile_height_px(const Label& label, int tile_width_px) {
  return std::max(1, tile_width_px * label.camera.height / label.camera.width);
}

std::array<std::string, 2> lens_lines(const Label& label) {
  const Distortion& lens = label.distortion;
  return {fmt::format("fov {:.2f}°  k1 {:+.3g}  k2 {:+.3g}  k3 {:+.3g}", degrees(hfov_rad(label.camera)),
                      lens.k1, lens.k2, lens.k3),
          fmt::format("p1 {:+.2g}  p2 {:+.2g}  cx {:.1f}  cy {:.1f}  zoom {:.3f}", lens.p1, lens.p2,
                      label.camera.cx, label.camera.cy, label.zoom)};
}

/// Of another family: the angle that the image shows, and the first four parameters.
std::array<std::string, 2> lens_lines(const ModelLabel& label) {
  std::string numbers;
  const auto all = parameters(label.camera.lens);
  for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 4); ++i)
    numbers += fmt::format("{}{} {:+.3g}", i > 0 ? "  " : "", all[i].first, all[i].second);
  return {fmt::format("{}  shows {:.2f}°", family_name(label.camera.lens),
                      degrees(label.seen.horizontal_rad.value_or(0))),
          numbers};
}

void draw_caption(OIIO::ImageBuf& sheet, int x, int y, const Captions& captions, const DatasetImage& image,
                  const DatasetGroup& group) {
  const auto [first, second] = group.model ? lens_lines(*group.model) : lens_lines(group.label);
  const std::string title = fmt::format("{}  {}", image.file.parent_path().string(), to_string(image.part));
  for (const std::string& line : {title, first, second}) {
    y += captions.line_px;
    OIIO::ImageBufAlgo::render_text(sheet, x, y, line, captions.text_px, "DejaVuSans", {0.92f, 0.92f, 0.92f});
  }
}

}  // namespace

std::string ContactSheetOptions::fault() const {
  if (rows_per_set < 1 || rows_per_set > 100) return "rows: must lie in [1, 100]";
  if (columns < 1 || columns > 100) return "columns: must lie in [1, 100]";
  if (tile_width_px < 64 || tile_width_px > 4096) return "tile-width: must lie in [64, 4096]";
  return "";
}

OIIO::ImageBuf contact_sheet(const Dataset& dataset, const ContactSheetOptions& options) {
  const std::vector<SheetRow> rows = choose_sheet_rows(dataset, options.rows_per_set, options.columns);
  const auto label_of = [&](const DatasetImage& image) -> const Label& {
    return dataset.groups[image.group].label;
  };
  const Captions captions(options.tile_width_px);
  int height = gap_px;
  std::size_t columns = 1;
  for (const SheetRow& row : rows) {
    height += tile_height_px(label_of(*row.front()), options.tile_width_px) + captions.height_px + gap_px;
    columns = std::max(columns, row.size());
  }
  const int width = gap_px + static_cast<int>(columns) * (options.tile_width_px + gap_px);
  OIIO::ImageBuf sheet(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8));
  OIIO::ImageBufAlgo::fill(sheet, {0.09f, 0.09f, 0.1f});
  int y = gap_px;
  for (const SheetRow& row : rows) {
    int x = gap_px;
    const int tile_height = tile_height_px(label_of(*row.front()), options.tile_width_px);
    for (const DatasetImage* image : row) {
      OIIO::ImageBufAlgo::paste(sheet, x, y, 0, 0,
                                thumbnail(dataset.root / image->file, {options.tile_width_px, tile_height}));
      draw_caption(sheet, x, y + tile_height, captions, *image, dataset.groups[image->group]);
      x += options.tile_width_px + gap_px;
    }
    y += tile_height + captions.height_px + gap_px;
  }
  return sheet;
}

}  // namespace cps
