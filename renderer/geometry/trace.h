#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "renderer/geometry/geometry.h"

/// Rays against the scene: the only place that knows Embree.
namespace cps {

struct Ray {
  Vec3 origin;
  Vec3 direction;  ///< unit length
  float t_near = 0;
  float t_far = std::numeric_limits<float>::infinity();
  bool from_viewer = false;  ///< meets inside-out shells, which light passes
  std::uint32_t id = 0;      ///< decides, with the surface, whether a half-transparent surface stops the ray
};

struct Hit {
  std::uint32_t placement = RTC_INVALID_GEOMETRY_ID;
  std::uint32_t triangle = 0;
  float u = 0, v = 0;  ///< barycentric
  float t = 0;
  explicit operator bool() const { return placement != RTC_INVALID_GEOMETRY_ID; }
};

/// Rays that travel together.
constexpr int packet_size = 8;

/// The bounding volume hierarchy over placed geometry, which must outlive it. Built by one thread, so that
/// equally near surfaces meet in the same order whatever the machine.
class Bvh {
 public:
  explicit Bvh(const PlacedGeometry& placed);

  /// Takes over the transforms of the placements that ride with the car. There are some.
  void move_riding(const PlacedGeometry& placed);

  /// Nearest surface. Alpha masks cut holes; a half-transparent surface stops a share of the rays.
  Hit intersect(const Ray& ray) const;

  /// The same without the backs of single-sided materials, which glTF does not show to the viewer.
  Hit intersect_shown(const Ray& ray) const;

  /// As intersect() for rays that start alike; those with `active[i]` false are left alone.
  void intersect_coherent(const Ray (&rays)[packet_size], const bool (&active)[packet_size],
                          Hit (&hits)[packet_size]) const;

  /// The share of light that passes between the ray's ends, tinted by glass: 0 behind anything opaque.
  Color transmittance(const Ray& ray) const;

  /// The same for rays that run alike.
  void transmittance_coherent(const Ray (&rays)[packet_size], const bool (&active)[packet_size],
                              Color (&transmittance)[packet_size]) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  using Device = std::unique_ptr<RTCDeviceTy, Release>;
  using SceneHandle = std::unique_ptr<RTCSceneTy, Release>;

  Device device;
  std::vector<SceneHandle> shared_scenes;
  SceneHandle scene;
  SceneHandle riding;  ///< what moves with the car, asked after the other; null: nothing does
};

}  // namespace cps
