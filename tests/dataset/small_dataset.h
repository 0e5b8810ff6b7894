#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "dataset/dense/bearings.h"
#include "dataset/dense/dense_file.h"
#include "dataset/job/finish.h"
#include "dataset/job/frames.h"
#include "dataset/job/write_label.h"
#include "dataset/labels/group_label.h"
#include "dataset/pixels/image_file.h"
#include "files/files.h"
#include "files/png.h"
#include "random/counter_hash.h"
#include "sampler/plan/plan.h"
#include "tests/sampler/plain_scene.h"
#include "tests/temporary_folder.h"

namespace cps {

inline Plan small_plan(const std::vector<DenseLabel>& labels = {}) {
  Recipe recipe;
  recipe.labels = labels;
  recipe.name = "small";
  recipe.seed = 5;
  recipe.scenes = {"plain.glb"};
  recipe.sizes = {{64, 36}};
  recipe.base_hfov_deg = {60, 120};
  recipe.views = 6;
  recipe.lenses = 2;
  Plan plan = make_plan(recipe, Rig{}, {{.file = "plain.glb"}},
                        [](const std::filesystem::path&) { return DrivenScene{.scene = plain_scene(6)}; });
  if (!plan.scenes[0].classes.empty()) plan.scenes[0].classes = {{.id = 7, .name = "road"}};
  return plan;
}

/// Pixels of a dense label as if the camera stood in a sphere of 10 m that is one object of class 7.
inline OIIO::ImageBuf sphere_label(const ModelCamera& camera, const FrameRow& frame, DenseLabel kind) {
  if (kind > DenseLabel::semantic) return bearing_label(camera, frame.gravity, kind);
  OIIO::ImageBuf pixels(dense_spec(kind, {camera.pinhole.width, camera.pinhole.height}));
  if (kind >= DenseLabel::instance) {
    std::fill_n(static_cast<std::uint16_t*>(pixels.localpixels()), pixels.spec().image_pixels(),
                kind == DenseLabel::instance ? 1 : 7);
    return pixels;
  }
  const OIIO::ImageBuf rays = bearing_label(camera, frame.gravity, DenseLabel::rays);
  const auto* ray = static_cast<const float*>(rays.localpixels());
  auto* value = static_cast<float*>(pixels.localpixels());
  for (std::size_t i = 0; i < pixels.spec().image_pixels(); ++i) {
    if (kind == DenseLabel::depth) value[i] = 10 * ray[3 * i + 2];
    if (kind == DenseLabel::distance) value[i] = 10;
    for (std::size_t c = 0; kind == DenseLabel::normal && c < 3; ++c) value[3 * i + c] = -ray[3 * i + c];
  }
  return pixels;
}

/// The camera of a group's images.
inline ModelCamera camera_of_group(const Plan& plan, const PlannedGroup& group) {
  if (group.model) return *group.model;
  const Label label = group_label(plan, group);
  return {{}, label.camera, label.distortion};
}

/// A whole dataset whose pictures are noise: everything but the rendering.
inline void write_small_dataset(const std::filesystem::path& root, const Plan& plan) {
  for (const PlannedGroup& group : plan.groups) write_label(root, plan, group);
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
      const FrameRow frame = frame_row({&view, &record, &record.images.back()});
      for (const DenseLabel kind : plan.recipe.labels) {
        const std::string bytes =
            encode_dense(sphere_label(camera_of_group(plan, plan.groups[g]), frame, kind), kind);
        write_file(root / dense_file(file, kind), bytes);
        record.images.back().dense.push_back({.label = kind, .bytes = bytes.size(), .sha256 = sha256(bytes)});
      }
    }
    records[record.view] = record;
  }
  finish_dataset(root, plan, records, std::vector<std::string>(plan.scenes.size(), "0123"));
}

}  // namespace cps
