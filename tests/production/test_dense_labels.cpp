#include <atomic>
#include <catch2/catch.hpp>

#include "dataset/dense/dense_file.h"
#include "distortion/inverse/inverse.h"
#include "files/files.h"
#include "production/dense_labels.h"
#include "renderer/paths/build_render_scene.h"
#include "tests/production/floor_and_sphere.h"
#include "tests/production/tiny_dataset.h"

using namespace cps;

namespace {

/// The labels of one image of a floor and a sphere, read back from their files.
struct LabelledView {
  TemporaryFolder folder = {};
  Recipe recipe = {};
  PlannedView view = {};
  ViewImages wanted = {};
  LitScene lit = {};
  std::vector<DenseRecord> records = {};

  explicit LabelledView(const Distortion& lens) {
    for (std::size_t i = 0; i < dense_label_names.size(); ++i)
      recipe.labels.push_back(static_cast<DenseLabel>(i));
    view.camera.pitch_deg = -3;
    view.camera.roll_deg = 2;
    wanted.images.push_back(
        {.file = "group/000007.png",
         .lens = {.distortion = lens, .camera = {96, 60, 52, 52, 50.5, 27.25}, .certified = {}},
         .sensor = {}});
    const Scene scene = floor_and_sphere();
    lit.scene = build_render_scene(scene, {});
    lit.labels = instance_labels(scene, recipe.labels);
    std::atomic<std::int64_t> cpu_ns = 0;
    records = make_dense_labels(recipe, view, wanted, lit, folder.path, cpu_ns).at(0);
  }

  OIIO::ImageBuf read(DenseLabel label) const {
    return read_dense(folder.path / dense_file("group/000007.png", label), label);
  }
};

constexpr Distortion strong{-0.29, 0.11, -0.015, 0.004, -0.006};

/// Of a float that was computed from floats.
Approx near(double value) {
  return Approx(value).epsilon(3e-6).margin(3e-6);
}

}  // namespace

TEST_CASE("every label has a file with the recorded length and hash") {
  const LabelledView labelled(strong);
  REQUIRE(labelled.records.size() == dense_label_names.size());
  for (const DenseRecord& record : labelled.records) {
    const std::string bytes = read_file(labelled.folder.path / dense_file("group/000007.png", record.label));
    CHECK(bytes.size() == record.bytes);
    CHECK(sha256(bytes) == record.sha256);
  }
}

TEST_CASE("labels of a floor and a sphere through a strong lens are their closed forms") {
  const LabelledView labelled(strong);
  const Pinhole camera = labelled.wanted.images[0].lens.camera;
  const Eigen::Isometry3d world_from_camera =
      world_from_vehicle(labelled.view.place) * vehicle_from_camera(labelled.view.camera);
  const Eigen::Vector3d from = world_from_camera.translation(), center(7, 1.5, 0.5);
  const OIIO::ImageBuf depth = labelled.read(DenseLabel::depth),
                       distance = labelled.read(DenseLabel::distance),
                       normal = labelled.read(DenseLabel::normal),
                       instance = labelled.read(DenseLabel::instance),
                       semantic = labelled.read(DenseLabel::semantic), rays = labelled.read(DenseLabel::rays),
                       latitude = labelled.read(DenseLabel::latitude);
  const auto id = [](const OIIO::ImageBuf& image, int x, int y) {
    return *static_cast<const std::uint16_t*>(image.pixeladdr(x, y));
  };
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-3, -3), Eigen::Vector2d(3, 3));
  int on_floor = 0, on_sphere = 0, in_sky = 0;
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector2d ideal =
          undistort(strong, frame_on_plane(camera).merged(box), to_plane(camera, {x, y})).value();
      const Eigen::Vector3d in_camera = ideal.homogeneous().normalized();
      const Eigen::Vector3d ray = world_from_camera.linear() * in_camera;
      for (int c = 0; c < 3; ++c) CHECK(rays.getchannel(x, y, 0, c) == near(in_camera[c]));
      CHECK(latitude.getchannel(x, y, 0, 0) == near(degrees(std::asin(ray.y()))).margin(1e-4));
      const double along = (center - from).dot(ray), miss = (center - from - along * ray).norm();
      if (std::abs(miss - 1) < 3e-3) continue;  // the silhouette of a sphere made of triangles
      if (miss < 1) {
        ++on_sphere;
        CHECK(id(instance, x, y) == 2);
        CHECK(id(semantic, x, y) == 2);
        // Its facets lie up to 4e-5 m inside it, more for rays that graze it.
        const double t = along - std::sqrt(1 - miss * miss), grazing = std::sqrt(1 - miss * miss);
        CHECK(distance.getchannel(x, y, 0, 0) == Approx(t).margin(4e-5 / std::max(0.05, grazing)));
        continue;
      }
      const double t = -from.y() / ray.y();
      if (t > 0 && (from + t * ray).cwiseAbs().maxCoeff() < 390) {
        ++on_floor;
        CHECK(distance.getchannel(x, y, 0, 0) == Approx(t).epsilon(3e-6 * std::max(1.0, t / from.y())));
        CHECK(depth.getchannel(x, y, 0, 0) ==
              Approx(t * in_camera.z()).epsilon(3e-6 * std::max(1.0, t / from.y())));
        const Eigen::Vector3d up = world_from_camera.linear().row(1).transpose();
        for (int c = 0; c < 3; ++c) CHECK(normal.getchannel(x, y, 0, c) == near(up[c]));
        CHECK(id(instance, x, y) == 1);
        CHECK(id(semantic, x, y) == 1);
      } else if (ray.y() > 0) {
        ++in_sky;
        CHECK(std::isinf(depth.getchannel(x, y, 0, 0)));
        CHECK(std::isinf(distance.getchannel(x, y, 0, 0)));
        CHECK(id(instance, x, y) == 0);
        CHECK(id(semantic, x, y) == 0);
      }
    }
  CHECK(on_floor > 1000);
  CHECK(on_sphere > 100);
  CHECK(in_sky > 1000);
}

TEST_CASE(
    "a dataset's labels are the same bytes for any threads, and are made again where they are missing") {
  TinyDataset one, two;
  for (TinyDataset* dataset : {&one, &two}) {
    dataset->job.recipe.labels = {DenseLabel::depth, DenseLabel::instance, DenseLabel::semantic};
    dataset->plan = plan_of(dataset->job, {});
  }
  one.make();
  std::size_t labels = 0;
  for (const auto& [name, bytes] : one.contents()) labels += is_dense_file(name);
  CHECK(labels == 3 * 12);
  Journal journal(two.root, {});
  make_views(two.plan, two.remaining(), journal, two.root, 1, {});
  CHECK(two.contents() == one.contents());

  const std::string image = one.files_of(2)[1];
  std::filesystem::remove(one.root / dense_file(image, DenseLabel::semantic));
  CHECK(one.remaining() == std::vector<std::int64_t>{2});
  std::filesystem::resize_file(one.root / dense_file(one.files_of(4)[0], DenseLabel::depth), 100);
  CHECK(one.remaining() == std::vector<std::int64_t>{2, 4});
  one.make();
  CHECK(two.contents() == one.contents());
}
