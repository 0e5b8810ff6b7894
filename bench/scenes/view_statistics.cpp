#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <iostream>

#include "bench/scenes/view_classes.h"
#include "files/files.h"
#include "files/plot.h"
#include "numbers/angles.h"
#include "production/scene_files.h"
#include "renderer/aov.h"
#include "renderer/render.h"
#include "sampler/plan/plan.h"
#include "scenes/gltf_import.h"
#include "sensor/develop.h"

/// Makes the tables and pictures of docs/benchmarks/cities.md: statistics of what a camera like KITTI's sees
/// in each style, next to those of real frames. `view_statistics FOLDER VIEWS [FRAME.png …]` makes the
/// cities, a sheet of 48 views of each style and the diagrams in FOLDER.
namespace {

using namespace cps;
namespace fs = std::filesystem;

constexpr CityStyle styles[] = {CityStyle::european, CityStyle::downtown, CityStyle::suburb,
                                CityStyle::industrial};
constexpr int cities_per_style = 4, conditions_per_city = 3;
constexpr int width = 348, height = 128;  // a quarter of 1392 x 512; statistics use half of that
constexpr int samples = 2, sheet_samples = 16, sheet_views = 48, sheet_columns = 6;
constexpr float edge_threshold = 40;  // of the Sobel gradient, in 8-bit levels
constexpr Interval luminance_range{0, 256}, angle_range{0, 180};

/// KITTI's camera 0 of 2011-09-26, unrectified (Geiger et al. 2013).
Camera kitti_camera(const PlannedView& view) {
  constexpr double scale = width / 1392.0;
  return {.world_from_camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera),
          .pinhole = {.width = width,
                      .height = height,
                      .fx = scale * 984.2439,
                      .fy = scale * 980.8141,
                      .cx = scale * 690.5 - 0.5,
                      .cy = scale * 233.6966 - 0.5},
          .lens = Distortion{
              .k1 = -0.3728755, .k2 = 0.2037299, .k3 = -0.07233722, .p1 = 0.002219027, .p2 = 0.001383707}};
}

struct Statistics {
  std::array<double, view_class_count> pixels = {};
  std::vector<double> luminance, edge_angle_deg;
};

/// Adds gray levels and edge directions of an 8-bit picture at half its size. An edge's angle is that of its
/// line: 0 horizontal, 90 vertical.
void add_picture(Statistics& statistics, const OIIO::ImageBuf& picture) {
  const OIIO::ROI half(0, width / 2, 0, height / 2, 0, 1, 0, picture.nchannels());
  const OIIO::ImageBuf small = OIIO::ImageBufAlgo::resize(picture, "box", 0, half);
  std::vector<float> gray(static_cast<std::size_t>(half.width()) * half.height());
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x) {
      const auto level = [&](int c) { return small.getchannel(x, y, 0, c); };
      gray[static_cast<std::size_t>(y) * half.width() + x] =
          255 *
          (small.nchannels() < 3 ? level(0) : 0.299f * level(0) + 0.587f * level(1) + 0.114f * level(2));
    }
  for (float level : gray) statistics.luminance.push_back(level);
  const auto at = [&](int x, int y) { return gray[static_cast<std::size_t>(y) * half.width() + x]; };
  for (int y = 1; y + 1 < half.height(); ++y)
    for (int x = 1; x + 1 < half.width(); ++x) {
      const float right = at(x + 1, y - 1) + 2 * at(x + 1, y) + at(x + 1, y + 1) - at(x - 1, y - 1) -
                          2 * at(x - 1, y) - at(x - 1, y + 1);
      const float down = at(x - 1, y + 1) + 2 * at(x, y + 1) + at(x + 1, y + 1) - at(x - 1, y - 1) -
                         2 * at(x, y - 1) - at(x + 1, y - 1);
      if (std::hypot(right, down) < edge_threshold) continue;
      const double angle = degrees(std::atan2(right, down));
      statistics.edge_angle_deg.push_back(angle < 0 ? angle + 180 : angle);
    }
}

void add_classes(Statistics& statistics, const OIIO::ImageBuf& ids, const std::vector<ViewClass>& classes) {
  for (OIIO::ImageBuf::ConstIterator<std::uint32_t, std::uint32_t> pixel(ids); !pixel.done(); ++pixel)
    ++statistics.pixels[static_cast<int>(classes[static_cast<std::uint32_t>(pixel[0])])];
}

Recipe recipe_of(CityStyle style, int views) {
  Recipe recipe;
  recipe.cities = cities_per_style;
  recipe.city_styles = {style};
  recipe.conditions_per_scene = conditions_per_city;
  recipe.sizes = {{width, height}};
  recipe.base_hfov_deg = {80};
  recipe.views = views;
  return recipe;
}

OIIO::ImageBuf photograph(const RenderScene& scene, const PlannedView& view, int samples_per_pixel) {
  const OIIO::ImageBuf linear =
      render(scene, kitti_camera(view), {.samples = samples_per_pixel, .seed = view.seed});
  const Stream sensor = make_stream(view.seed, "sensor");
  return develop(linear, meter_exposure(linear), draw_sensor(SensorOptions{}, sensor),
                 make_stream(sensor.key, "noise"));
}

Statistics see(CityStyle style, int views, const fs::path& folder) {
  const Recipe recipe = recipe_of(style, views);
  const std::vector<PlannedScene> scenes = plan_scenes(recipe, folder / "cities");
  make_scene_files(scenes, folder / "cities");
  const Plan plan = make_plan(recipe, Rig{}, scenes,
                              [](const fs::path& file) { return DrivenScene{.scene = import_gltf(file)}; });
  Statistics statistics;
  OIIO::ImageBuf sheet(
      OIIO::ImageSpec(sheet_columns * width, sheet_views / sheet_columns * height, 3, OIIO::TypeDesc::UINT8));
  std::shared_ptr<const RenderScene> scene;
  std::vector<ViewClass> classes;
  int loaded = -1, shown = 0;
  for (std::size_t v = 0; v < plan.views.size(); ++v) {
    const PlannedView& view = plan.views[v];
    if (loaded != view.condition) {
      const PlannedCondition& condition = plan.conditions[view.condition];
      const Scene city = import_gltf(plan.scenes[condition.scene].file);
      classes = classes_of_materials(city);
      scene = build_render_scene(city, condition.light.daylight);
      loaded = view.condition;
    }
    add_picture(statistics, photograph(*scene, view, samples));
    add_classes(statistics, render_aovs(*scene, kitti_camera(view), {}, {Aov::material})[0].image, classes);
    if (v * sheet_views < shown * plan.views.size()) continue;
    OIIO::ImageBufAlgo::paste(sheet, shown % sheet_columns * width, shown / sheet_columns * height, 0, 0,
                              photograph(*scene, view, sheet_samples));
    ++shown;
  }
  sheet.specmod().attribute("Compression", "jpeg:85");
  sheet.write((folder / ("views_" + to_string(style) + ".jpg")).string());
  std::cout << to_string(style) << ": " << plan.views.size() << " views; " << plan.places.brief() << "\n";
  return statistics;
}

std::string table_row(const std::string& name, const Statistics& statistics) {
  double total = 0;
  for (double pixels : statistics.pixels) total += pixels;
  std::string row = "| " + name + " |";
  for (double pixels : statistics.pixels)
    row += total > 0 ? fmt::format(" {:.1f} |", 100 * pixels / total) : std::string(" |");
  return row + "\n";
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::cerr << "view_statistics FOLDER VIEWS [FRAME.png …]\n";
    return 2;
  }
  const fs::path folder = arguments[1];
  std::vector<std::pair<std::string, Statistics>> seen;
  for (CityStyle style : styles)
    seen.emplace_back(to_string(style), see(style, std::stoi(arguments[2]), folder));
  Statistics real;
  for (int i = 3; i < count; ++i) {
    const OIIO::ImageBuf whole(arguments[i]);
    const OIIO::ImageSpec& spec = whole.spec();  // KITTI's colour frames end in a black row and column
    const OIIO::ImageBuf frame = OIIO::ImageBufAlgo::cut(
        whole, OIIO::ROI(0, spec.width - 1, 0, spec.height - 1, 0, 1, 0, spec.nchannels));
    add_picture(real, OIIO::ImageBufAlgo::resize(frame, "box", 0,
                                                 OIIO::ROI(0, width, 0, height, 0, 1, 0, frame.nchannels())));
  }
  if (count > 3) seen.emplace_back("real frames", real);

  Plot luminance{
      .title = "Gray levels", .x_label = "level", .y_label = "density", .x_range = luminance_range};
  Plot edges{.title = "Directions of edges",
             .x_label = "degrees; 0 horizontal, 90 vertical",
             .y_label = "density",
             .x_range = angle_range};
  std::string table = "| |";
  for (int i = 0; i < view_class_count; ++i) table += " " + to_string(static_cast<ViewClass>(i)) + " % |";
  table += "\n|---|";
  for (int i = 0; i < view_class_count; ++i) table += "---|";
  table += "\n";
  for (const auto& [name, statistics] : seen) {
    luminance.series.push_back(histogram(name, statistics.luminance, luminance_range, 64));
    edges.series.push_back(histogram(name, statistics.edge_angle_deg, angle_range, 60));
    table += table_row(name, statistics);
  }
  std::cout << table;
  const Plot plots[] = {luminance, edges};
  write_file(folder / "view_statistics.svg", to_svg(plots, 2));
  return 0;
}
