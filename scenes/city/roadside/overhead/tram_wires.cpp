#include "scenes/city/roadside/overhead/tram_wires.h"

#include "scenes/city/roadside/overhead/wire.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

constexpr double at_mast_m = 7.1;  ///< above the pavement
constexpr double span_sag_m = 0.9, span_radius_m = 0.009, contact_radius_m = 0.009, dropper_radius_m = 0.006;
constexpr double contact_sag_m = 0.05, usual_spacing_m = 27, max_tram_span_m = 75;

/// The points from which one track's contact wire hangs.
using Holders = std::vector<Vec3>;

/// Adds a span across the street with a dropper to each track's contact wire.
void add_cross_span(Mesh& mesh, const Materials& m, const Mast& left, const Mast& right,
                    const std::vector<double>& tracks_left_m, std::vector<Holders>& holders) {
  const Vec3 from = lift(right.position, kerb_height_m + at_mast_m),
             to = lift(left.position, kerb_height_m + at_mast_m);
  Surface& cable = mesh.surfaces[m.cable];
  add_wire(cable, from, to, span_sag_m, span_radius_m);
  const double width = (to - from).norm();
  for (std::size_t i = 0; i < tracks_left_m.size(); ++i) {
    const double t = 0.5 + tracks_left_m[i] / width;
    const Vec3 hung = from + (to - from) * t - Vec3(0, 4 * span_sag_m * t * (1 - t), 0);
    const Vec3 holder(hung.x(), contact_wire_m, hung.z());
    add_tube(cable, hung, holder, dropper_radius_m, dropper_radius_m, 3);
    holders[i].push_back(holder);
  }
}

}  // namespace

Mesh tram_wires(const StreetNetwork& network, int street, const Materials& m, const CityOptions& options) {
  Mesh mesh{"tram wires " + network.streets[street].name, {}};
  const StreetProfile& p = network.streets[street].profile;
  if (!p.tram_tracks) return mesh;
  std::vector<double> tracks_left_m;  // from the centre line
  if (p.lanes_forward > 0) tracks_left_m.push_back(p.forward_lane_offset(p.lanes_forward - 1));
  if (p.lanes_backward > 0) tracks_left_m.push_back(p.backward_lane_offset(p.lanes_backward - 1));
  std::vector<Holders> holders(tracks_left_m.size());
  for (const int segment : network.streets[street].segments) {
    const std::vector<Mast> masts = overhead_along(network, segment, options).masts;
    for (std::size_t i = 0; i + 1 < masts.size(); i += 2)
      add_cross_span(mesh, m, masts[i], masts[i + 1], tracks_left_m, holders);
  }
  for (const Holders& held : holders)
    for (std::size_t i = 0; i + 1 < held.size(); ++i) {
      const double span_m = (held[i + 1] - held[i]).norm();
      if (span_m > max_tram_span_m) continue;
      add_wire(mesh.surfaces[m.cable], held[i], held[i + 1],
               contact_sag_m * span_m * span_m / (usual_spacing_m * usual_spacing_m), contact_radius_m);
    }
  if (mesh.surfaces[m.cable].indices.empty()) mesh.surfaces.clear();
  return mesh;
}

}  // namespace cps::city
