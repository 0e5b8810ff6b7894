#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// The scene before the camera, as plain data. World frame: glTF's, y up, metres.
namespace cps {

enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };

/// An image and its sampler. Texels are RGBA, 8 bit, rows from the top; uv (0,0) is the top-left corner.
struct Texture {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  bool srgb = false;  ///< colour, to be decoded before filtering; else data
  bool nearest = false;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

/// A material's texture (−1: none) and its coordinates. `uv_transform` is that of KHR_texture_transform.
struct TextureSlot {
  int texture = -1;
  int uv_set = 0;
  Eigen::Affine2f uv_transform = Eigen::Affine2f::Identity();
};

enum class AlphaMode { opaque, mask, blend };

/// A glTF 2.0 metallic-roughness material with the Khronos extensions that cities use. Factors are linear.
struct Material {
  std::string name;
  Eigen::Vector4f base_color = {1, 1, 1, 1};
  float metallic = 1, roughness = 1;
  Eigen::Vector3f emissive = {0, 0, 0};  ///< radiance, kcd/m², before its texture
  TextureSlot base_color_texture, metallic_roughness_texture, normal_texture, emissive_texture;
  float normal_scale = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;

  float ior = 1.5f;    ///< index of refraction (KHR_materials_ior); 0: total reflection
  float specular = 1;  ///< strength of dielectric reflection (KHR_materials_specular); texture: alpha
  Eigen::Vector3f specular_color = {1, 1, 1};  ///< its tint at normal incidence; may exceed 1
  TextureSlot specular_texture, specular_color_texture;
  float clearcoat = 0, clearcoat_roughness = 0;  ///< KHR_materials_clearcoat; textures: red and green
  TextureSlot clearcoat_texture, clearcoat_roughness_texture, clearcoat_normal_texture;
  float clearcoat_normal_scale = 1;
  float transmission =
      0;  ///< share of light through thin clear glass (KHR_materials_transmission); texture: red
  TextureSlot transmission_texture;
  bool unlit = false;  ///< shows the base colour regardless of light (KHR_materials_unlit)
};

/// All texture slots of a material (Material or const Material).
template <class M>
auto texture_slots(M& m) {
  return std::array{&m.base_color_texture,       &m.metallic_roughness_texture,
                    &m.normal_texture,           &m.emissive_texture,
                    &m.specular_texture,         &m.specular_color_texture,
                    &m.clearcoat_texture,        &m.clearcoat_roughness_texture,
                    &m.clearcoat_normal_texture, &m.transmission_texture};
}

/// A light without size (KHR_lights_punctual).
struct PunctualLight {
  enum class Kind { point, spot, directional };
  std::string name;
  Kind kind = Kind::point;
  Eigen::Vector3f position = {0, 0, 0};    ///< world
  Eigen::Vector3f direction = {0, 0, -1};  ///< of the light of a spot or directional light: world, unit
  /// Point and spot: luminous intensity, kcd; directional: illuminance of a surface that faces it, klx.
  Eigen::Vector3f intensity = {0, 0, 0};
  float cos_inner = 1,
        cos_outer = 0;  ///< of a spot's half angles: full inside the inner, none outside the outer
};

/// Triangles of one material. Arrays other than `triangles` have one entry per vertex; `uv1`, `colors` and
/// `tangents` may be empty. A tangent's w is the handedness of the bitangent.
struct Mesh {
  std::string name;
  int material = 0;
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Eigen::Vector2f> uv0, uv1;
  std::vector<Eigen::Vector4f> tangents;
  std::vector<Eigen::Vector4f> colors;  ///< linear RGBA, multiplies the base colour
  std::vector<Eigen::Vector3i> triangles;
  bool is_enclosure = false;  ///< a part of what closes the sky over the scene: seen, but light passes
};

/// A mesh placed in the world. With a negative determinant (a mirrored node), the mesh's front faces stay
/// front faces.
struct Instance {
  int mesh = 0;
  Eigen::Affine3f world_from_mesh = Eigen::Affine3f::Identity();
  bool rides = false;  ///< moves with the car: its transform leads to the vehicle frame
  int object = 0;      ///< index into Scene::objects; a thing of several materials is several instances
};

/// A stretch of a lane, in metres from its first point.
struct LaneStretch {
  double from_m = 0, to_m = 0;
  double length_m() const { return to_m - from_m; }
};

/// A drivable lane, by its centre line in driving direction.
struct Lane {
  std::string street;  ///< lanes of one street see the same houses and share a split
  float width_m = 3.25f;
  std::vector<Eigen::Vector3f> points;
  std::vector<int> next = {};  ///< lanes (indices into Scene::lanes) that begin where it ends; may be empty
  std::vector<LaneStretch> occupied = {};  ///< by vehicles
};

/// A perspective camera from the scene's file. Camera frame: x right, y down, z forward.
struct SceneCamera {
  std::string name;
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  double vfov_rad = 1;
};

struct Scene {
  std::string name, credits;  ///< credits: the file's asset.copyright, copied to dataset.json
  std::vector<Texture> textures;
  std::vector<Material> materials;  ///< never empty once imported
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<PunctualLight> lights;
  std::vector<Lane> lanes;
  std::vector<SceneCamera> cameras;
  Eigen::AlignedBox3f bounds;  ///< of all instances, world
  /// Where the file has the point that is (0, 0, 0) here: 0, but near a scene that the file places farther
  /// than 10 km from its own, as georeferenced ones are, because floats are coarse there.
  Eigen::Vector3d origin = {0, 0, 0};
  std::vector<std::string> import_warnings = {};  ///< what the importer left out or changed, a line each
  /// Names of the things placed in the world: a node with a mesh, or each of its repetitions under
  /// EXT_mesh_gpu_instancing. "" where the file has no name; a scene made by hand may go without.
  std::vector<std::string> objects = {};
  std::string generator = {};  ///< the program that wrote the file: asset.generator
};

}  // namespace cps
