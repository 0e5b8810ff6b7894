#include "trainer/images/orientation/edge_cells.h"

#include <algorithm>

namespace cps {
namespace {

/// Pixels of a row that belong to one cell.
struct Segment {
  int begin, end, column;
};

/// A gradient is at most 16 · 255 along each axis, so the squares of 64 pixels fit into 32 bits.
constexpr int longest_segment = 64;

std::vector<Segment> segments_of(int width, int columns) {
  std::vector<Segment> segments;
  for (int x = 1; x + 1 < width;) {
    Segment segment{x, x + 1, cell_of(x, width, columns)};
    while (segment.end + 1 < width && segment.end - x < longest_segment &&
           cell_of(segment.end, width, columns) == segment.column)
      ++segment.end;
    segments.push_back(segment);
    x = segment.end;
  }
  return segments;
}

/// The slopes of a row with its neighbours above and below.
void scharr(const std::uint8_t* above, const std::uint8_t* row, const std::uint8_t* below, int width,
            std::int32_t* gx, std::int32_t* gy) {
  for (int x = 1; x + 1 < width; ++x) {
    gx[x] = 3 * (above[x + 1] - above[x - 1] + below[x + 1] - below[x - 1]) + 10 * (row[x + 1] - row[x - 1]);
    gy[x] = 3 * (below[x - 1] - above[x - 1] + below[x + 1] - above[x + 1]) + 10 * (below[x] - above[x]);
  }
}

void add_segment(EdgeCells& cells, std::size_t cell, const Segment& segment, const std::int32_t* gx,
                 const std::int32_t* gy) {
  std::int32_t steep_x = 0, product_x = 0, flat_y = 0, steep_y = 0, product_y = 0, flat_x = 0, energy = 0;
  for (int x = segment.begin; x < segment.end; ++x) {
    const std::int32_t xx = gx[x] * gx[x], xy = gx[x] * gy[x], yy = gy[x] * gy[x];
    const bool is_vertical = xx > 16 * yy, is_horizontal = yy > 16 * xx;
    steep_x += is_vertical ? xx : 0;
    product_x += is_vertical ? xy : 0;
    flat_y += is_vertical ? yy : 0;
    steep_y += is_horizontal ? yy : 0;
    product_y += is_horizontal ? xy : 0;
    flat_x += is_horizontal ? xx : 0;
    energy += xx + yy;
  }
  EdgeTensor &vertical = cells.families[0][cell], &horizontal = cells.families[1][cell];
  vertical.steep += steep_x;
  vertical.product += product_x;
  vertical.flat += flat_y;
  horizontal.steep += steep_y;
  horizontal.product += product_y;
  horizontal.flat += flat_x;
  cells.energy += energy;
}

}  // namespace

double coherence(const EdgeTensor& tensor) {
  if (tensor.steep == 0) return 1;
  constexpr double agreeing_deviation = .03;  // 1.7 degrees
  const double steep = static_cast<double>(tensor.steep), tilt = static_cast<double>(tensor.product) / steep,
               variance = std::max(0.0, static_cast<double>(tensor.flat) / steep - tilt * tilt);
  return 1 / (1 + variance / (agreeing_deviation * agreeing_deviation));
}

EdgeCells edge_cells(const GrayView& picture, const ImageSize& grid) {
  EdgeCells cells{.picture = picture.size, .grid = grid, .families = {}};
  for (auto& family : cells.families) family.resize(pixel_count(grid));
  const auto [width, height] = picture.size;
  const std::vector<Segment> segments = segments_of(width, grid.width);
  std::vector<std::int32_t> gx(width), gy(width);
  for (int y = 1; y + 1 < height; ++y) {
    const std::uint8_t* row = picture.pixels + static_cast<std::size_t>(y) * width;
    scharr(row - width, row, row + width, width, gx.data(), gy.data());
    const std::size_t first = static_cast<std::size_t>(cell_of(y, height, grid.height)) * grid.width;
    for (const Segment& segment : segments)
      add_segment(cells, first + segment.column, segment, gx.data(), gy.data());
  }
  return cells;
}

}  // namespace cps
