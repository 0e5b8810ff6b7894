#include "renderer/aov.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "renderer/camera_path.h"
#include "renderer/paths/hit_ids.h"
#include "renderer/paths/surface.h"

namespace cps {
namespace {

/// Few suffice, since light and shadow play no part.
constexpr int max_albedo_samples = 16;

struct AovDescription {
  const char* name;
  std::vector<std::string> channels;
  OIIO::TypeDesc type;
};

const AovDescription& description(Aov aov) {
  static const std::vector<AovDescription> table = {
      {"depth", {"Z"}, OIIO::TypeDesc::FLOAT},
      {"distance", {"Y"}, OIIO::TypeDesc::FLOAT},
      {"normal", {"X", "Y", "Z"}, OIIO::TypeDesc::FLOAT},
      {"albedo", {"R", "G", "B"}, OIIO::TypeDesc::FLOAT},
      {"position", {"X", "Y", "Z"}, OIIO::TypeDesc::FLOAT},
      {"instance", {"id"}, OIIO::TypeDesc::UINT32},
      {"material", {"id"}, OIIO::TypeDesc::UINT32},
  };
  return table[static_cast<std::size_t>(aov)];
}

ImageLayer empty_layer(Aov aov, int width, int height) {
  const AovDescription& what = description(aov);
  OIIO::ImageSpec spec(width, height, static_cast<int>(what.channels.size()), what.type);
  spec.channelnames = what.channels;
  return {what.name, OIIO::ImageBuf(spec)};
}

/// Hit of the ray through a pixel's centre.
struct CentralHit {
  Surface surface;
  HitIds ids;
  Vec3 position;
  float distance, cos_axis;  ///< along the ray, metres; of its angle to the optical axis
};

/// The central path passes a hair beside the pixel's centre (central_offset_px): where the ray through the
/// centre itself meets the plane of the triangle that was hit.
CentralHit hit_at_center(const Path& path, const Hit& hit, const Surface& surface, const HitIds& ids,
                         const Vec3& center, const Vec3& optical_axis) {
  const float along = surface.geometric_normal.dot(path.ray.direction),
              along_center = surface.geometric_normal.dot(center);
  // The two differ by more than this only where the plane is all but parallel to them.
  const bool is_oblique = along < 0.5f * along_center && along > 2 * along_center;
  const float distance = is_oblique ? hit.t * (along / along_center) : hit.t;
  return {.surface = surface,
          .ids = ids,
          .position = surface.position + (distance * center - hit.t * path.ray.direction),
          .distance = distance,
          .cos_axis = center.dot(optical_axis)};
}

void set_floats(OIIO::ImageBuf& image, const TilePixel& at, const Vec3& value) {
  std::copy_n(value.data(), image.nchannels(), static_cast<float*>(image.pixeladdr(at.x, at.y)));
}

void set_id(OIIO::ImageBuf& image, const TilePixel& at, std::uint32_t id) {
  *static_cast<std::uint32_t*>(image.pixeladdr(at.x, at.y)) = id;
}

void set_central(Aov aov, OIIO::ImageBuf& image, const TilePixel& at, const CentralHit& central) {
  switch (aov) {
    case Aov::depth:
      return set_floats(image, at, Vec3::Constant(central.distance * central.cos_axis));
    case Aov::distance:
      return set_floats(image, at, Vec3::Constant(central.distance));
    case Aov::normal:
      return set_floats(image, at, central.surface.shading.normal);
    case Aov::position:
      return set_floats(image, at, central.position);
    case Aov::instance:
      return set_id(image, at, central.ids.instance + 1);
    case Aov::material:
      return set_id(image, at, central.ids.material + 1);
    case Aov::albedo:
      return;
  }
}

/// Fills in a pixel whose central ray meets nothing, or where the lens shows nothing: infinite distances; all
/// else stays 0.
void set_nothing(Aov aov, OIIO::ImageBuf& image, const TilePixel& at) {
  if (aov == Aov::depth || aov == Aov::distance)
    set_floats(image, at, Vec3::Constant(std::numeric_limits<float>::infinity()));
}

/// What every tile's layers are rendered with.
struct AovTiles {
  const RenderScene& scene;
  const PathSource& source;
  const std::vector<Aov>& wanted;
  std::vector<ImageLayer>& layers;
  int width, height;

  bool contains(const TilePixel& at) const { return at.x < width && at.y < height; }

  Surface surface_of(const Path& path, const Hit& hit) const {
    return make_surface(scene.placed, path.ray, hit, path.cone_spread * hit.t, 0.0f);
  }

  void set_hit(const TilePixel& at, const CentralHit& hit) const {
    for (std::size_t k = 0; k < wanted.size(); ++k) set_central(wanted[k], layers[k].image, at, hit);
  }

  /// Fills in all layers but albedo, from the pixels' central rays.
  void set_centers(const Tile& tile) const {
    const Vec3 optical_axis = source.rays.world_from_camera.col(2);
    for (int first = 0; first < Tile::pixels; first += packet_size) {
      Path paths[packet_size];
      Hit hits[packet_size];
      Vec3 centers[packet_size];
      for (int i = 0; i < packet_size; ++i) {
        const TilePixel at = tile_pixel(tile, first + i);
        if (!contains(at)) continue;
        const CameraPixel pixel = camera_pixel(source.rays, at.x, at.y);
        paths[i] = central_path(source, pixel, at.x, at.y);
        const CameraRay center = camera_ray(source.rays, pixel, Eigen::Vector2f::Zero());
        centers[i] = center.is_seen ? center.direction : paths[i].ray.direction;
      }
      first_hits(scene, paths, hits);
      for (int i = 0; i < packet_size; ++i) {
        const TilePixel at = tile_pixel(tile, first + i);
        if (!contains(at)) continue;
        if (paths[i].alive && hits[i])
          set_hit(at, hit_at_center(paths[i], hits[i], surface_of(paths[i], hits[i]), ids_of(scene, hits[i]),
                                    centers[i], optical_axis));
        else
          for (std::size_t k = 0; k < wanted.size(); ++k) set_nothing(wanted[k], layers[k].image, at);
      }
    }
  }

  /// Fills in albedo, the mean over a pixel's samples.
  void set_albedo(const Tile& tile, int samples, OIIO::ImageBuf& image) const {
    for (int index = 0; index < Tile::pixels; ++index) {
      const TilePixel at = tile_pixel(tile, index);
      if (!contains(at)) continue;
      const CameraPixel pixel = camera_pixel(source.rays, at.x, at.y);
      Color sum = Color::Zero();
      for (int first = 0; first < samples; first += packet_size) {
        Path paths[packet_size];
        Hit hits[packet_size];
        for (int i = 0; i < packet_size && first + i < samples; ++i)
          paths[i] = camera_path(source, pixel, at.x, at.y, first + i);
        first_hits(scene, paths, hits);
        for (int i = 0; i < packet_size; ++i)
          if (paths[i].alive && hits[i]) sum += surface_of(paths[i], hits[i]).base_color;
      }
      set_floats(image, at, (sum / static_cast<float>(samples)).matrix());
    }
  }
};

}  // namespace

const std::vector<std::string>& aov_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (int aov = 0; aov <= static_cast<int>(Aov::material); ++aov)
      all.emplace_back(description(static_cast<Aov>(aov)).name);
    return all;
  }();
  return names;
}

Aov aov_from_string(const std::string& name) {
  std::string known;
  for (std::size_t i = 0; i < aov_names().size(); ++i) {
    if (aov_names()[i] == name) return static_cast<Aov>(i);
    known += (i > 0 ? ", " : "") + aov_names()[i];
  }
  throw std::runtime_error("aov '" + name + "': must be one of " + known);
}

std::vector<ImageLayer> render_aovs(const RenderScene& scene, const Camera& camera,
                                    const RenderOptions& options, const std::vector<Aov>& wanted) {
  if (const std::string fault = options.fault(); !fault.empty()) throw std::runtime_error(fault);
  const PathSource source = make_path_source(camera, options);
  const int width = camera.pinhole.width, height = camera.pinhole.height;
  std::vector<ImageLayer> layers;
  for (const Aov aov : wanted) layers.push_back(empty_layer(aov, width, height));
  const AovTiles tiles{scene, source, wanted, layers, width, height};
  for_each_tile(width, height, [&](const Tile& tile) {
    tiles.set_centers(tile);
    for (std::size_t k = 0; k < wanted.size(); ++k)
      if (wanted[k] == Aov::albedo)
        tiles.set_albedo(tile, std::min(options.samples, max_albedo_samples), layers[k].image);
  });
  return layers;
}

}  // namespace cps
