#pragma once

#include <memory>
#include <vector>

#include "renderer/geometry/geometry.h"
#include "renderer/geometry/ray.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace cps {

/// A bounding volume hierarchy over placed geometry, which must outlive it. One thread builds it, so that
/// equally near surfaces are found in the same order on any machine. Only trace.cpp and alpha_filter.cpp
/// call Embree.
class Bvh {
 public:
  explicit Bvh(const PlacedGeometry& placed);

  /// Takes over the transforms of the placements that ride with the car. There must be at least one.
  void move_riding(const PlacedGeometry& placed);

  /// Nearest surface. Alpha masks cut holes; a half-transparent surface stops a share of the rays.
  Hit intersect(const Ray& ray) const;

  /// The same without the backs of single-sided materials, which glTF does not show to the viewer.
  Hit intersect_shown(const Ray& ray) const;

  /// intersect() for a packet of rays with similar origins and directions. Where `active[i]` is false,
  /// `hits[i]` is not set.
  void intersect_coherent(const Ray (&rays)[packet_size], const bool (&active)[packet_size],
                          Hit (&hits)[packet_size]) const;

  /// Share of light that passes between the ray's ends, tinted by glass: 0 behind anything opaque.
  Color transmittance(const Ray& ray) const;

  /// transmittance() for a packet of rays with similar origins and directions.
  void transmittance_coherent(const Ray (&rays)[packet_size], const bool (&active)[packet_size],
                              Color (&transmittance)[packet_size]) const;

 private:
  struct Release {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
  };
  using Device = std::unique_ptr<RTCDeviceTy, Release>;
  using SceneHandle = std::unique_ptr<RTCSceneTy, Release>;

  Device device;
  std::vector<SceneHandle> shared_scenes;
  SceneHandle scene;
  SceneHandle riding;  ///< what moves with the car, queried after `scene`; null: nothing does
};

}  // namespace cps
