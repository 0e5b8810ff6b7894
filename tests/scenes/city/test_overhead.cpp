#include <catch2/catch.hpp>
#include <set>

#include "scenes/city/draws.h"
#include "scenes/city/roadside/furniture/signals.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/roadside/overhead/tram_wires.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/tram_tracks.h"

using namespace cps;
using namespace cps::city;

namespace {

constexpr MaterialId cable = 7;

Materials wire_materials() {
  Materials m{};
  m.cable = cable;
  return m;
}

}  // namespace

TEST_CASE("masts stand on pavements and wires hang above all vehicles") {
  for (const CityStyle style : {CityStyle::european, CityStyle::suburb, CityStyle::industrial}) {
    INFO(to_string(style));
    int masts = 0, wires = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const CityOptions options{.seed = seed, .style = style};
      const StreetNetwork network = draw_street_network(options);
      for (int s = 0; s < static_cast<int>(network.streets.size()); ++s) {
        for (const int segment : network.streets[s].segments)
          for (const Mast& mast : overhead_along(network, segment, options).masts) {
            ++masts;
            const Polyline& centre = network.segments[segment].centre;
            const double off = distance_to_line(centre, mast.position) - network.segments[segment].half_width;
            CHECK(off > kerb_width_m + 0.15);
            CHECK(off < network.streets[s].profile.pavement_m);
            const Vec2 facing(std::cos(mast.heading_rad), std::sin(mast.heading_rad));
            CHECK(distance_to_line(centre, mast.position + facing) < distance_to_line(centre, mast.position));
          }
        const city::Mesh mesh = overhead_wires(network, s, wire_materials(), options);
        if (!mesh.surfaces.count(cable)) continue;
        const Surface& surface = mesh.surfaces.at(cable);
        wires += static_cast<int>(surface.positions.size());
        for (const Eigen::Vector3f& p : surface.positions) {
          CHECK(p.allFinite());
          CHECK(p.y() > 4.8f);
          CHECK(p.y() < 8.3f);
        }
      }
    }
    CHECK(masts > 30);
    CHECK(wires > 500);
  }
}

TEST_CASE("tram contact wires hang over the tracks of streets with tram masts") {
  int streets = 0, bare = 0, over_tracks = 0;
  for (const CityStyle style : {CityStyle::european, CityStyle::downtown})
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      INFO(to_string(style) << " " << seed);
      const CityOptions options{.seed = seed, .style = style};
      const StreetNetwork network = draw_street_network(options);
      const std::vector<TramTrack> tracks = tram_tracks(network);
      for (int s = 0; s < static_cast<int>(network.streets.size()); ++s) {
        const city::Mesh mesh = tram_wires(network, s, wire_materials(), options);
        const bool has_tram = network.streets[s].profile.tram_tracks;
        bare += has_tram && mesh.surfaces.empty();  // too short for masts
        if (mesh.surfaces.empty()) continue;
        CHECK(has_tram);
        ++streets;
        for (const Eigen::Vector3f& p : mesh.surfaces.at(cable).positions) {
          CHECK(p.allFinite());
          CHECK(p.y() > 5.0f);
          CHECK(p.y() < 7.4f);
          if (p.y() > contact_wire_m + 0.03) continue;
          double off = 1e9;
          for (const TramTrack& track : tracks)
            if (track.street == s) off = std::min(off, distance_to_line(track.centre, Vec2(p.x(), -p.z())));
          CHECK(off < 0.6);
          ++over_tracks;
        }
        for (const int segment : network.streets[s].segments) {
          const Overhead overhead = overhead_along(network, segment, options);
          CHECK(overhead.kind == OverheadKind::tram);
          CHECK(overhead.masts.size() % 2 == 0);
        }
      }
    }
  CHECK(streets > 8);
  CHECK(bare < streets / 8);
  CHECK(over_tracks > 1000);
}

TEST_CASE("opposite arms of a junction show the same light, crossing arms the other") {
  int pairs = 0, lights = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const CityOptions options{.seed = seed, .style = CityStyle::downtown};
    const StreetNetwork network = draw_street_network(options);
    for (const Junction& junction : network.junctions)
      for (const Side& a : junction.arms)
        for (const Side& b : junction.arms) {
          if (a == b || !network.is_road(a) || !network.is_road(b)) continue;
          const Signal own = signal_at(network, a.segment, a.reversed, options),
                       other = signal_at(network, b.segment, b.reversed, options);
          lights += own != Signal::none;
          if (own == Signal::none || other == Signal::none) continue;
          const auto direction = [&](const Side& arm) {
            const Polyline line = network.line(arm, 0);
            return Vec2((line[1] - line[0]).normalized());
          };
          const double sine = std::abs(cross(direction(a), direction(b)));
          if (sine < 0.2) CHECK(own == other);
          if (sine > 0.98) CHECK(own != other);
          ++pairs;
        }
  }
  CHECK(lights > 50);
  CHECK(pairs > 50);
}
