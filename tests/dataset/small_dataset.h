#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "dataset/job/finish.h"
#include "dataset/labels/group_label.h"
#include "dataset/pixels/image_file.h"
#include "files/files.h"
#include "files/png.h"
#include "random/counter_hash.h"
#include "sampler/plan/plan.h"
#include "tests/sampler/plain_scene.h"
#include "tests/temporary_folder.h"

namespace cps {

inline Plan small_plan() {
  Recipe recipe;
  recipe.name = "small";
  recipe.seed = 5;
  recipe.scenes = {"plain.glb"};
  recipe.sizes = {{64, 36}};
  recipe.base_hfov_deg = {60, 120};
  recipe.views = 6;
  recipe.lenses = 2;
  return make_plan(recipe, Rig{}, {{.file = "plain.glb"}},
                   [](const std::filesystem::path&) { return DrivenScene{.scene = plain_scene(6)}; });
}

/// A whole dataset whose pictures are noise: everything but the rendering.
inline void write_small_dataset(const std::filesystem::path& root, const Plan& plan) {
  for (const PlannedGroup& group : plan.groups)
    write_json(root / group.folder / "calibration.json", to_json(group_label(plan, group)));
  std::map<std::int64_t, ViewRecord> records;
  for (std::size_t v = 0; v < plan.views.size(); ++v) {
    const PlannedView& view = plan.views[v];
    ViewRecord record{.view = static_cast<std::int64_t>(v), .exposure = 1.25, .images = {}};
    for (int g : view.groups) {
      const Pinhole& camera = plan.sets[view.set].camera;
      OIIO::ImageBuf image(OIIO::ImageSpec(camera.width, camera.height, 3, OIIO::TypeDesc::UINT8));
      auto* pixels = static_cast<std::uint8_t*>(image.localpixels());
      for (int i = 0; i < 3 * camera.width * camera.height; ++i)
        pixels[i] = static_cast<std::uint8_t>(random_bits(substream(make_stream(view.seed, "noise"), g), i));
      const std::string png = encode_png(image);
      const std::string file = plan.groups[g].folder + "/" + image_name(plan, view);
      write_file(root / file, png);
      record.images.push_back({.file = file,
                               .sensor = {},
                               .bytes = png.size(),
                               .sha256 = sha256(png),
                               .pixels_sha256 = pixels_sha256(image)});
    }
    records[record.view] = record;
  }
  finish_dataset(root, plan, records, std::vector<std::string>(plan.scenes.size(), "0123"));
}

}  // namespace cps
