#include "dataset/job/masters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/csv.h"
#include "files/files.h"
#include "files/json_keys.h"
#include "numbers/angles.h"
#include "sampler/recipe/recipe_keys.h"
#include "sampler/recipe/recipe_values.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// The base of the view's lenses that its master was made for: the widest.
const Pinhole& widest_base(const Plan& plan, const PlannedView& view) {
  return plan
      .groups[*std::ranges::min_element(view.groups, {}, [&](int g) { return plan.groups[g].lens.base.fx; })]
      .lens.base;
}

Part part_from(const std::string& word, const fs::path& file) {
  for (Part part : {Part::train, Part::val, Part::test})
    if (word == to_string(part)) return part;
  throw std::runtime_error(file.string() + ": part: '" + word + "' is none of train, val, test");
}

}  // namespace

std::string master_file_name(const Plan& plan, const PlannedView& view) {
  return fmt::format("masters/{}/{}_{:06}.exr", plan.sets[view.set].folder,
                     plan.rig.cameras[view.rig_camera].name, view.index);
}

std::string masters_csv(const Plan& plan, const std::map<std::int64_t, ViewRecord>& records) {
  std::string csv =
      "file,part,width,height,fx,fy,cx,cy,image_width,image_height,base_hfov_deg,set_hfov_deg,exposure,"
      "sha256\n";
  for (std::size_t v = 0; v < plan.views.size(); ++v) {
    const PlannedView& view = plan.views[v];
    const ViewRecord& record = records.at(static_cast<std::int64_t>(v));
    const Pinhole &m = view.master, &base = widest_base(plan, view);
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(record.master->file),
                       to_string(view.part), m.width, m.height, m.fx, m.fy, m.cx, m.cy, base.width,
                       base.height, degrees(hfov_rad(base)), degrees(hfov_rad(plan.sets[view.set].camera)),
                       record.exposure, record.master->sha256);
  }
  return csv;
}

std::vector<KeptMaster> read_masters(const fs::path& dataset) {
  const fs::path file = dataset / "masters.csv";
  if (!fs::exists(file))
    throw std::runtime_error(
        file.string() + ": is not there: the dataset keeps no masters; make one with keep_masters = true");
  const CsvTable table = read_csv(file);
  const auto column = [&](const char* name) { return table.column(name); };
  const std::size_t name = column("file"), part = column("part"), width = column("width"),
                    height = column("height"), fx = column("fx"), fy = column("fy"), cx = column("cx"),
                    cy = column("cy"), image_width = column("image_width"),
                    image_height = column("image_height"), base_hfov = column("base_hfov_deg"),
                    set_hfov = column("set_hfov_deg"), exposure = column("exposure"), hash = column("sha256");
  std::vector<KeptMaster> masters;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto number = [&](std::size_t c, double least, double most) {
      const double value = table.number(r, c);
      if (value >= least && value <= most) return value;
      throw std::runtime_error(fmt::format("{}: line {}: {}: must lie in [{}, {}]", file.string(), r + 2,
                                           table.header[c], least, most));
    };
    const auto pixels = [&](std::size_t c) { return static_cast<int>(number(c, 1, 1 << 20)); };
    const auto output_sized = [&](std::size_t hfov) {
      return pinhole_from_hfov(pixels(image_width), pixels(image_height), radians(number(hfov, 1, 179)));
    };
    masters.push_back({.file = table.rows[r][name],
                       .part = part_from(table.rows[r][part], file),
                       .camera = {pixels(width), pixels(height), number(fx, 1e-3, 1e9), number(fy, 1e-3, 1e9),
                                  number(cx, -1e6, 1e6), number(cy, -1e6, 1e6)},
                       .base = output_sized(base_hfov),
                       .set = output_sized(set_hfov),
                       .exposure = number(exposure, 0, 1e30),
                       .sha256 = table.rows[r][hash]});
  }
  return masters;
}

Recipe read_recipe(const fs::path& dataset) {
  const std::string file = (dataset / "dataset.json").string();
  const nlohmann::json json = read_json(file);
  const JsonKeys keys = JsonKeys{json, file}.object("recipe");
  Recipe recipe;
  for_each_recipe_key(recipe, [&](const char* key, auto& member, const char*) {
    if (!keys.json.contains(key)) return;  // of an older version: its default
    try {
      parse_value(keys.text(key), member);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(file + ": recipe: " + key + ": " + error.what());
    }
  });
  if (const std::string fault = recipe.fault(); !fault.empty())
    throw std::runtime_error(file + ": recipe: " + fault);
  return recipe;
}

}  // namespace cps
