#include <catch2/catch.hpp>

#include "renderer/camera_path.h"
#include "renderer/image_error.h"
#include "tests/renderer/estimates.h"

using namespace cps;
using namespace cps::handmade;

namespace {

Scene corner() {
  Scene scene;
  scene.materials = {material({0.7f, 0.5f, 0.3f, 1}), material({0.9f, 0.9f, 0.9f, 1}, 0.5f, 0.4f)};
  scene.materials[1].emissive = {0.1f, 0.2f, 0.3f};
  add(scene, quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10}));
  add(scene, quad({-5, 0, -2}, {10, 0, 0}, {0, 5, 0}, 1));
  return scene;
}

const Camera view = camera({1, 1.5, 4}, {0, 1, -2}, 24, 16, 80);

SkyAndSun day() {
  return {make_constant_sky(Color(0.5f, 0.6f, 0.8f)),
          make_sun(Vec3(0.3f, 0.8f, 0.6f).normalized(), 0.01, Color::Constant(3))};
}

}  // namespace

TEST_CASE("Passes over parts of the samples add up to the picture") {
  const RenderScene scene(corner(), day());
  const RenderOptions options{.samples = 24};
  const OIIO::ImageBuf whole = render(scene, view, options);
  const OIIO::ImageBuf a = render_samples(scene, view, options, {0, 5}),
                       b = render_samples(scene, view, options, {5, 19});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      for (int c = 0; c < 3; ++c) {
        const float sum = (5 * pixel(a, x, y)[c] + 19 * pixel(b, x, y)[c]) / 24;
        REQUIRE(sum == Approx(pixel(whole, x, y)[c]).epsilon(1e-5));
      }
  CHECK_THROWS(render_samples(scene, view, options, {20, 5}));
  CHECK_THROWS(render_samples(scene, view, options, {-1, 5}));
}

TEST_CASE("The variance layer is that of samples were they independent, less what stratifying them saves") {
  // Let σ² be the variance of one sample and v that of a mean of n. The expected squared deviation of the n
  // from their mean is n (σ² − v), so the layer holds (σ² − v)/(n − 1) on average. Pairs of seeds give σ² and
  // v: half of the squared difference.
  const RenderScene scene(corner(), day());
  constexpr int pairs = 32, samples = 16, values = 24 * 16 * 3;
  const auto rendered = [&](int count, int seed, OIIO::ImageBuf* variance) -> Eigen::ArrayXd {
    const RenderOptions options{.samples = count, .seed = static_cast<std::uint64_t>(seed)};
    const OIIO::ImageBuf image = render(scene, view, options, nullptr, variance);
    return Eigen::Map<const Eigen::ArrayXf>(static_cast<const float*>(image.localpixels()), values)
        .cast<double>();
  };
  const auto half_squared_difference = [&](int count, int pair) {
    return 0.5 * (rendered(count, 1000 * count + 2 * pair, nullptr) -
                  rendered(count, 1000 * count + 2 * pair + 1, nullptr))
                     .square()
                     .mean();
  };
  const Estimate sigma2 = estimate(
      pairs, [&](int pair) { return Eigen::Array3d::Constant(half_squared_difference(1, pair)).eval(); });
  const Estimate v = estimate(pairs, [&](int pair) {
    return Eigen::Array3d::Constant(half_squared_difference(samples, pair)).eval();
  });
  const Estimate claimed = estimate(pairs, [&](int seed) {
    OIIO::ImageBuf variance;
    rendered(samples, seed, &variance);
    const Eigen::Map<const Eigen::ArrayXf> layer(static_cast<const float*>(variance.localpixels()), values);
    return Eigen::Array3d::Constant(layer.cast<double>().mean()).eval();
  });
  const double difference = (samples - 1) * claimed.mean.x() - (sigma2.mean.x() - v.mean.x());
  const double standard_error =
      std::sqrt(std::pow(samples - 1, 2) * claimed.variance.x() + sigma2.variance.x() + v.variance.x());
  CAPTURE(claimed.mean.x(), sigma2.mean.x(), v.mean.x(), standard_error);
  CHECK(std::abs(difference) < 5 * standard_error);
  CHECK(standard_error < 0.05 * sigma2.mean.x());  // or nothing would be shown
  CHECK(claimed.mean.x() > v.mean.x());
}

TEST_CASE("A summary counts the rays of all paths") {
  const RenderScene scene(corner(), day());
  const RenderOptions options{.samples = 2};
  RenderSummary summary;
  render(scene, view, options, &summary);
  const PathSource source = make_path_source(view, options);
  std::uint64_t rays = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      for (int sample = 0; sample < options.samples; ++sample) {
        PathRecord record;
        Path paths[packet_size];
        paths[0] = camera_path(source, camera_pixel(source.rays, x, y), x, y, sample);
        paths[0].record = &record;
        trace_paths(scene, options.max_shaded_vertices, paths);
        REQUIRE(paths[0].rays >= record.vertices.size());
        rays += paths[0].rays;
      }
  CHECK(summary.rays == rays);
  CHECK(summary.samples == 24 * 16 * 2);
}

TEST_CASE("A replayed path's contributions add up to its radiance, and to the picture") {
  const RenderScene scene(corner(), day());
  const RenderOptions options{.samples = 8};
  const OIIO::ImageBuf image = render(scene, view, options);
  const PathSource source = make_path_source(view, options);
  for (int x = 0; x < 24; x += 3) {
    Color mean = Color::Zero();
    for (int sample = 0; sample < options.samples; ++sample) {
      PathRecord record;
      Path paths[packet_size];
      paths[0] = camera_path(source, camera_pixel(source.rays, x, 9), x, 9, sample);
      paths[0].record = &record;
      trace_paths(scene, options.max_shaded_vertices, paths);
      Color sum = record.beyond;
      for (const VertexRecord& vertex : record.vertices)
        sum += vertex.emission + vertex.sun + vertex.sky + vertex.lamps;
      REQUIRE((sum - paths[0].radiance).abs().maxCoeff() < 1e-5f);
      REQUIRE(std::string(record.end) != "");
      mean += paths[0].radiance / static_cast<float>(options.samples);
    }
    CHECK((mean - pixel(image, x, 9)).abs().maxCoeff() < 1e-5f);
  }
}

TEST_CASE("Errors of an image that is off by a constant") {
  OIIO::ImageBuf reference(OIIO::ImageSpec(4, 2, 3, OIIO::TypeDesc::FLOAT));
  OIIO::ImageBuf image(reference.spec());
  for (int i = 0; i < 4 * 2 * 3; ++i) {
    static_cast<float*>(reference.localpixels())[i] = 2;
    static_cast<float*>(image.localpixels())[i] = i % 2 ? 2.3f : 2.1f;
  }
  const ImageError error = image_error(image, reference);
  CHECK(error.bias == Approx(0.1));
  CHECK(error.rmse == Approx(std::sqrt(0.05)));
  CHECK(error.rel_mse == Approx(0.05 / 4.04));
  CHECK_THROWS_WITH(image_error(image, OIIO::ImageBuf(OIIO::ImageSpec(5, 2, 3, OIIO::TypeDesc::FLOAT))),
                    Catch::Contains("5 x 2"));
}
