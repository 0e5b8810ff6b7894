#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "tests/temporary_folder.h"

/// Builds a glTF file from JSON that the test edits and one buffer.
struct GltfMaker {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::vector<unsigned char> buffer;

  /// Appends bytes, 4-byte aligned, as a buffer view; returns its index.
  int add_view(const void* data, std::size_t size, std::size_t stride = 0);
  /// Adds an accessor over a view; `type` as in glTF ("VEC3"), `component` 5121, 5123, …
  int add_accessor(int view, int component, const char* type, std::size_t count, bool normalized = false);
  /// Adds a view of floats and an accessor over all of it; returns the accessor's index.
  int add_floats(const std::vector<float>& values, const char* type);
  template <class T>
  int add(const std::vector<T>& values, int component, const char* type, std::size_t count,
          bool normalized = false) {
    return add_accessor(add_view(values.data(), values.size() * sizeof(T)), component, type, count,
                        normalized);
  }
  /// Adds an image file to the buffer and a texture of it; returns the texture's index.
  int add_texture(const std::vector<unsigned char>& image_file);

  nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

  std::vector<unsigned char> glb() const;
  /// The JSON text, with the buffer at `uri`, or as a data URI if `uri` is empty.
  std::string gltf(const std::string& uri = "") const;
};

/// One triangle (0,0,0) (1,0,0) (0,1,0) in the xy plane with POSITION only, one node, one scene.
GltfMaker one_triangle();

/// A unit square in the xy plane facing +z: u right, v down, two triangles, u16 indices, NORMAL and
/// TEXCOORD_0, and material 0.
GltfMaker one_square();

/// The triangle with a skin of two joints: node 1, at (10,0,0) in the rest pose and (4,0,0) in the bind pose,
/// and node 2, at the origin and turned by 90° about z. The mesh's node is moved too, which skinned meshes
/// ignore.
GltfMaker skinned_triangle();

/// Encodes width × height × `channels` values in an image format ("png", "jpeg", …).
std::vector<unsigned char> encode_image(const std::string& format, int width, int height, int channels,
                                        const std::vector<std::uint8_t>& values);

std::string base64(const std::vector<unsigned char>& bytes);

using cps::TemporaryFolder;

void write_file(const std::filesystem::path& file, const void* data, std::size_t size);

/// Writes the bytes as a file and imports it.
cps::Scene import_bytes(const std::vector<unsigned char>& bytes,
                        std::vector<std::string>* warnings = nullptr);
cps::Scene import_glb(const GltfMaker& maker, std::vector<std::string>* warnings = nullptr);

/// The message with which the import refuses the file, without the file's name; "" if it is accepted.
std::string refusal(const std::vector<unsigned char>& bytes);
std::string refusal(const GltfMaker& maker);
