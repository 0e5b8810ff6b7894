#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "renderer/lights/direction_table.h"
#include "renderer/materials/bsdf.h"
#include "renderer/materials/microfacet.h"
#include "renderer/materials/specular_albedo.h"
#include "renderer/math/sobol.h"
#include "tests/renderer/statistics.h"

using namespace cps;

namespace {

using std::numbers::pi;

Vec3 at_cosine(float cosine) {
  return {std::sqrt(1 - cosine * cosine), 0, cosine};
}

Eigen::Vector2f uniform_pair(int i, const char* name) {
  const Stream stream = make_stream(3, name);
  return {static_cast<float>(random_uniform(stream, 2 * i)),
          static_cast<float>(random_uniform(stream, 2 * i + 1))};
}

/// ∫ over the upper hemisphere of f(direction) by the midpoint rule.
template <class F>
auto integrate_hemisphere(int rows, int columns, F f) {
  decltype(f(Vec3())) sum = f(Vec3(0, 0, 1)) * 0.0f;
  for (int r = 0; r < rows; ++r) {
    const double theta = (r + 0.5) * pi / 2 / rows;
    const double weight = std::sin(theta) * (pi / 2 / rows) * (2 * pi / columns);
    for (int c = 0; c < columns; ++c) {
      const double phi = (c + 0.5) * 2 * pi / columns;
      const Vec3 w =
          Eigen::Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta))
              .cast<float>();
      sum += f(w) * static_cast<float>(weight);
    }
  }
  return sum;
}

/// Mean sample weight: the directional albedo as the path tracer sees it.
Color sampled_albedo(const Bsdf& bsdf, const Vec3& wo) {
  constexpr int samples = 1 << 14;
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (int i = 0; i < samples; ++i) {
    const SobolSample sample = make_sobol_sample(1, 2, 3, static_cast<std::uint32_t>(i));
    sum += sample_bsdf(bsdf, wo, sample.pair(0).x(), sample.pair(1)).weight.cast<double>();
  }
  return (sum / samples).cast<float>();
}

}  // namespace

TEST_CASE("White furnace: no surface reflects more than it gets, a white dielectric reflects all of it") {
  for (float roughness : {0.05f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    for (float cosine : {0.05f, 0.2f, 0.5f, 0.8f, 0.99f}) {
      CAPTURE(roughness, cosine);
      const Vec3 wo = at_cosine(cosine);
      const Color white = sampled_albedo(make_bsdf({Color::Ones(), 0, roughness}, wo), wo);
      CHECK(white.maxCoeff() < 1.005f);
      CHECK(white.minCoeff() > 0.985f);
      for (float metallic : {0.0f, 0.5f, 1.0f}) {
        const Color mixed = sampled_albedo(make_bsdf({Color(1, 0.8f, 0.3f), metallic, roughness}, wo), wo);
        CHECK(mixed.maxCoeff() < 1.005f);
      }
    }
  }
}

TEST_CASE("White furnace: coats, tinted reflections and glass give back all that they get, or less") {
  for (float roughness : {0.1f, 0.5f, 1.0f}) {
    for (float cosine : {0.05f, 0.3f, 0.99f}) {
      CAPTURE(roughness, cosine);
      const Vec3 wo = at_cosine(cosine);
      BsdfParameters p{Color::Ones(), 0, roughness};
      p.dielectric_f0 = Color(0.1f, 0.02f, 0.3f);
      p.dielectric_f90 = 0.7f;
      CHECK(sampled_albedo(make_bsdf(p, wo), wo).maxCoeff() < 1.005f);
      CHECK(sampled_albedo(make_bsdf(p, wo), wo)(2) > 0.985f);  // the brightest reflection sets the base's

      p = {Color::Ones(), 0, roughness};
      p.transmission = 0.6f;
      p.straight = thin_glass_transmittance(p, cosine);
      CHECK(p.straight.x() > 0);
      const Color glass = sampled_albedo(make_bsdf(p, wo), wo);
      CHECK(glass.maxCoeff() < 1.005f);
      CHECK(glass.minCoeff() > 0.985f);

      p = {Color::Ones(), 0, 0.6f};
      p.clearcoat = 0.7f;
      p.clearcoat_roughness = roughness;
      const Color coated = sampled_albedo(make_bsdf(p, wo), wo);
      CHECK(coated.maxCoeff() < 1.005f);
      CHECK(coated.minCoeff() > 0.98f);
      p.transmission = 1;
      p.straight = thin_glass_transmittance(p, cosine);
      CHECK(sampled_albedo(make_bsdf(p, wo), wo).minCoeff() > 0.98f);
      CHECK(sampled_albedo(make_bsdf(p, wo), wo).maxCoeff() < 1.005f);
      p.metallic = 0.5f;
      p.clearcoat_normal = Vec3(0.3f, 0.1f, 1).normalized();
      p.straight = thin_glass_transmittance(p, cosine);
      CHECK(sampled_albedo(make_bsdf(p, wo), wo).maxCoeff() < 1.01f);
    }
  }
}

TEST_CASE("Without its layer a surface is Lambert's, exactly") {
  const Color albedo(0.7f, 0.4f, 0.1f);
  const Vec3 wo = at_cosine(0.3f);
  const Bsdf lambert =
      make_bsdf({.base_color = albedo, .dielectric_f0 = Color::Zero(), .dielectric_f90 = 0}, wo);
  for (float cosine : {0.1f, 0.5f, 1.0f}) {
    const BsdfValue value = evaluate_bsdf(lambert, wo, at_cosine(cosine));
    CHECK((value.f_cos / cosine * static_cast<float>(pi) - albedo).abs().maxCoeff() < 1e-5f);
    CHECK(value.pdf == Approx(cosine / pi));
  }
}

TEST_CASE("White metal loses what single scattering loses, and no more") {
  // Roughness 1 seen straight on has a closed form: D = 1/π and G₂/4cc = ½/(1 + µ), so ∫ µ/(1 + µ) dµ = 1 −
  // ln 2.
  CHECK(sampled_albedo(make_bsdf({Color::Ones(), 1, 1}, at_cosine(1)), at_cosine(1)).x() ==
        Approx(1 - std::log(2.0)).epsilon(0.005));
  // Straight on, α²/(1 + α²) of the microfacets lean beyond 45° and send the light down; masking takes a
  // little more.
  for (float roughness : {0.1f, 0.3f, 0.5f}) {
    const float alpha2 = std::pow(roughness, 4.0f);
    const float loss =
        1 - sampled_albedo(make_bsdf({Color::Ones(), 1, roughness}, at_cosine(1)), at_cosine(1)).x();
    CAPTURE(roughness, loss);
    CHECK(loss > 0.99f * alpha2 / (1 + alpha2) - 1e-4f);
    CHECK(loss < 2.5f * alpha2 / (1 + alpha2) + 1e-3f);
  }
}

TEST_CASE("Microfacets cover the surface that they make up") {
  for (float alpha : {0.1f, 0.4f, 1.0f}) {
    const float area =
        integrate_hemisphere(2000, 4, [&](const Vec3& h) { return ggx_distribution(h, alpha) * h.z(); });
    CHECK(area == Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("The layer's tabulated albedo is the integral of its value") {
  for (float roughness : {0.3f, 0.5f, 0.75f, 1.0f}) {
    for (float cosine : {0.1f, 0.35f, 0.7f, 1.0f}) {
      CAPTURE(roughness, cosine);
      const Vec3 wo = at_cosine(cosine);
      const float alpha = roughness * roughness;
      for (float f0 : {0.04f, 0.6f}) {
        const float integral = integrate_hemisphere(500, 500, [&](const Vec3& wi) {
          const Vec3 h = (wo + wi).normalized();
          const float fresnel = f0 + (1 - f0) * schlick_weight(wo.dot(h));
          return fresnel * ggx_distribution(h, alpha) * smith_visibility(cosine, wi.z(), alpha) * wi.z();
        });
        CHECK(specular_albedo(roughness, cosine)(f0) == Approx(integral).margin(0.006));
      }
    }
  }
}

TEST_CASE("The BSDF is reciprocal") {
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = sample_cosine_hemisphere(uniform_pair(i, "a")),
               b = sample_cosine_hemisphere(uniform_pair(i, "b"));
    if (a.z() < 0.01f || b.z() < 0.01f) continue;
    const Color base(0.9f, 0.5f, 0.1f);
    const Color forth = evaluate_bsdf(make_bsdf({base, 0.3f, 0.4f}, a), a, b).f_cos / b.z();
    const Color back = evaluate_bsdf(make_bsdf({base, 0.3f, 0.4f}, b), b, a).f_cos / a.z();
    for (int c = 0; c < 3; ++c) CHECK(forth[c] == Approx(back[c]).epsilon(1e-3));
  }
}

TEST_CASE("A weight is value over density, and the density is that of the samples") {
  // Chi squared over 20 × 20 cells of (cos θ, φ), expected counts by quadrature of the density in each cell.
  constexpr int cells = 20, samples = 200000, sub = 16;
  const Color base(0.8f, 0.6f, 0.4f);
  const Vec3 leaning = Vec3(0.2f, -0.1f, 1).normalized();
  const BsdfParameters surfaces[] = {
      {base, 0, 0.6f},
      {base, 1, 0.45f},
      {base, 1, 0.9f},
      {base, 0.5f, 0.7f},
      {.base_color = base, .roughness = 0.7f, .dielectric_f0 = {0.02f, 0.2f, 0.1f}, .dielectric_f90 = 0.6f},
      {.base_color = base, .dielectric_f0 = Color::Zero(), .dielectric_f90 = 0},
      {.base_color = base, .roughness = 0.9f, .clearcoat = 0.8f, .clearcoat_roughness = 0.5f},
      {.base_color = base,
       .metallic = 1,
       .roughness = 0.5f,
       .clearcoat = 1,
       .clearcoat_roughness = 0.6f,
       .clearcoat_normal = leaning}};
  for (const BsdfParameters& surface : surfaces) {
    for (float cosine : {0.15f, 0.6f, 0.98f}) {
      CAPTURE(surface.metallic, surface.roughness, surface.clearcoat, cosine);
      const Vec3 wo = at_cosine(cosine);
      const Bsdf bsdf = make_bsdf(surface, wo);
      std::vector<double> observed(cells * cells + 1), expected(cells * cells + 1);
      for (int i = 0; i < samples; ++i) {
        const BsdfSample s = sample_bsdf(bsdf, wo, uniform_pair(i, "lobe").x(), uniform_pair(i, "direction"));
        if (s.pdf <= 0 || s.wi.z() <= 0) {  // a leaning coat also reflects below the shading plane
          ++observed.back();
          continue;
        }
        const BsdfValue value = evaluate_bsdf(bsdf, wo, s.wi);
        REQUIRE(s.pdf == Approx(value.pdf));
        REQUIRE((s.weight * s.pdf - value.f_cos).abs().maxCoeff() <= 1e-4f * value.f_cos.maxCoeff() + 1e-6f);
        const int row = std::min(static_cast<int>(s.wi.z() * cells), cells - 1);
        const int column = std::min(static_cast<int>(turns_of_vector(s.wi.x(), s.wi.y()) * cells), cells - 1);
        ++observed[row * cells + column];
      }
      double inside = 0;
      for (int row = 0; row < cells; ++row) {
        for (int column = 0; column < cells; ++column) {
          double sum = 0;
          for (int i = 0; i < sub * sub; ++i) {
            const double z = (row + (i % sub + 0.5) / sub) / cells,
                         phi = 2 * pi * (column + (i / sub + 0.5) / sub) / cells;
            const double sine = std::sqrt(1 - z * z);
            const Vec3 wi = Eigen::Vector3d(sine * std::cos(phi), sine * std::sin(phi), z).cast<float>();
            sum += evaluate_bsdf(bsdf, wo, wi).pdf;
          }
          expected[row * cells + column] = samples * sum / (sub * sub) * (2 * pi / (cells * cells));
          inside += expected[row * cells + column];
        }
      }
      expected.back() = samples - inside;  // reflections about microfacets that point below the surface
      CHECK(expected.back() > -0.002 * samples);
      if (expected.back() < 5) expected.back() = observed.back() = 0;
      CHECK(chi_squared_p_value(observed, expected) > 1e-4);
    }
  }
}

TEST_CASE("Without its base a surface draws its other layers more often and reflects the same light") {
  const Color base(0.6f, 0.5f, 0.4f);
  for (const float cosine : {0.2f, 0.9f}) {
    const Vec3 wo = at_cosine(cosine);
    BsdfParameters half_glass{base, 0, 0.6f};
    half_glass.transmission = 0.5f;
    half_glass.straight = thin_glass_transmittance(half_glass, cosine);
    const BsdfParameters surfaces[] = {
        {base, 0, 0.5f},
        {base, 0.5f, 0.7f},
        half_glass,
        {.base_color = base, .roughness = 0.9f, .clearcoat = 0.8f, .clearcoat_roughness = 0.5f}};
    for (const BsdfParameters& surface : surfaces)
      for (const float times : {1.0f, 3.0f}) {
        CAPTURE(cosine, surface.metallic, surface.transmission, surface.clearcoat, times);
        const Bsdf all = make_bsdf(surface, wo);
        Bsdf layers = all;
        leave_out_base(layers, times);

        // As often as asked for, as far as there is room, and in the same proportions.
        const float before = 1 - all.diffuse_probability, drawn = std::min(1.0f, times * before);
        CHECK(1 - layers.diffuse_probability == Approx(drawn).margin(1e-5));
        CHECK(layers.specular_probability / drawn == Approx(all.specular_probability / before).margin(1e-5));
        CHECK(layers.straight_probability / drawn == Approx(all.straight_probability / before).margin(1e-5));

        // What is drawn and what is left out are the surface, for every pair of directions and in the mean.
        for (int i = 0; i < 50; ++i) {
          const Vec3 wi = sample_cosine_hemisphere(uniform_pair(i, "in"));
          const BsdfValue whole = evaluate_bsdf(all, wo, wi), parts = evaluate_bsdf(layers, wo, wi);
          CHECK((parts.f_cos + parts.base_f_cos - whole.f_cos).abs().maxCoeff() <
                1e-4f * whole.f_cos.maxCoeff() + 1e-6f);
        }
        const Color both = sampled_albedo(layers, wo) + base_albedo(all);
        CHECK((both - sampled_albedo(all, wo)).abs().maxCoeff() < 0.01f);
      }
  }
}

TEST_CASE("A near mirror reflects where it should") {
  const Vec3 wo = at_cosine(0.5f);
  const Bsdf mirror = make_bsdf({Color::Ones(), 1, 0}, wo);
  for (int i = 0; i < 100; ++i) {
    const BsdfSample s = sample_bsdf(mirror, wo, 0.5f, uniform_pair(i, "mirror"));
    REQUIRE(s.pdf > 0);
    CHECK((s.wi - Vec3(-wo.x(), 0, wo.z())).norm() < 0.2f);
    CHECK((s.weight - 1).abs().maxCoeff() < 0.001f);
  }
}
