#include "scenes/gltf/document/container.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <string_view>

#include "scenes/gltf/document/data_uris.h"
#include "scenes/gltf/document/draco.h"
#include "scenes/gltf/document/external_files.h"
#include "scenes/gltf/document/json_checks.h"
#include "scenes/gltf/document/meshopt.h"
#include "scenes/gltf/document/tinygltf_gaps.h"

namespace cps::gltf {
namespace {

using Bytes = std::vector<unsigned char>;

/// tinygltf stores file sizes in 32 bits and image sizes in 31.
constexpr std::size_t max_file_bytes = std::numeric_limits<std::int32_t>::max();

/// Memory per byte of JSON text: a value of "[1,1,1,…" is two bytes of text, 16 in nlohmann's tree and 150 in
/// tinygltf's.
constexpr std::size_t max_json_growth = 128;

/// Reads a regular file of at most `max_bytes`. On failure returns false and says why in `why`.
bool read_bytes(const std::filesystem::path& file, std::size_t max_bytes, Bytes& bytes, std::string& why) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return why = "no such file", false;
  if (!std::filesystem::is_regular_file(status)) return why = "is not a regular file", false;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return why = error.message(), false;
  if (size == 0) return why = "is empty", false;
  if (size > max_file_bytes) return why = "is larger than 2 GiB", false;
  if (size > max_bytes) return why = "is more than may be read for this scene", false;
  std::ifstream stream(file, std::ios::binary);
  bytes.resize(size);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    return why = "cannot be read", false;
  return true;
}

std::uint32_t little_endian_u32(const Bytes& bytes, std::size_t offset) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

bool is_glb(const Bytes& bytes) {
  return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

/// Checks the container (glTF 2.0 §4.4: a 12-byte header, then chunks of length, type and data, JSON first)
/// and returns its JSON.
std::string_view check_glb(const std::filesystem::path& file, const Bytes& bytes) {
  constexpr std::uint32_t json_chunk = 0x4E4F534A;
  if (bytes.size() < 20) refuse(file, "GLB header", "the file ends inside it: is it complete?");
  if (little_endian_u32(bytes, 4) != 2)
    refuse(file, "GLB header", "container version is not 2: convert the file to glTF 2.0");
  const std::size_t length = little_endian_u32(bytes, 8);
  if (length > bytes.size())
    refuse(file, "GLB header",
           "announces " + std::to_string(length) + " bytes, the file has " + std::to_string(bytes.size()) +
               ": is it complete?");
  for (std::size_t offset = 12; offset < length;) {
    if (length - offset < 8) refuse(file, "GLB chunk", "its header is cut off: is the file complete?");
    const std::size_t chunk = little_endian_u32(bytes, offset);
    if (chunk > length - offset - 8) refuse(file, "GLB chunk", "is longer than the file: is it complete?");
    if (chunk % 4 != 0) refuse(file, "GLB chunk", "its length is not a multiple of 4");
    offset += 8 + chunk;
  }
  if (length < 20 || little_endian_u32(bytes, 16) != json_chunk)
    refuse(file, "GLB chunk", "the first one is not JSON: is this a glTF file?");
  return {reinterpret_cast<const char*>(bytes.data()) + 20, little_endian_u32(bytes, 12)};
}

/// The file's bytes with its JSON replaced by `text`.
Bytes with_json(const Bytes& bytes, std::string text) {
  if (!is_glb(bytes)) return {text.begin(), text.end()};
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t other_chunks = 20 + std::size_t{little_endian_u32(bytes, 12)};
  Bytes changed(bytes.begin(), bytes.begin() + 20);
  changed.insert(changed.end(), text.begin(), text.end());
  changed.insert(changed.end(), bytes.begin() + other_chunks, bytes.begin() + little_endian_u32(bytes, 8));
  const auto length = static_cast<std::uint32_t>(changed.size()),
             json_length = static_cast<std::uint32_t>(text.size());
  std::memcpy(&changed[8], &length, sizeof length);
  std::memcpy(&changed[12], &json_length, sizeof json_length);
  return changed;
}

/// tinygltf's image callback: keeps the encoded bytes, which are decoded later. Skips images in buffer views,
/// because tinygltf passes a pointer it has not checked.
bool keep_image_bytes(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                      const unsigned char* bytes, int size, void*) {
  if (image->bufferView == -1) image->image.assign(bytes, bytes + size);
  return true;
}

/// The files that tinygltf may read, and how many bytes it may still read from them. The limit is on the
/// total because a thousand buffers can name the same large file.
struct ReadableFiles {
  ExternalFiles files;
  std::size_t bytes_left;

  /// The file with the stand-in name that `path` ends with.
  const ExternalFiles::File* find(const std::string& path) const {
    const auto found = files.by_stand_in.find(std::filesystem::path(path).filename().string());
    return found == files.by_stand_in.end() ? nullptr : &found->second;
  }
};

/// Lets tinygltf read these files only: by itself it would look in the current directory too.
tinygltf::FsCallbacks callbacks_for(ReadableFiles* readable) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string& path, void* user) {
    const ExternalFiles::File* file = static_cast<ReadableFiles*>(user)->find(path);
    std::error_code error;
    return file != nullptr && std::filesystem::is_regular_file(file->path, error);
  };
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = [](Bytes* out, std::string* error, const std::string& path, void* user) {
    auto& readable = *static_cast<ReadableFiles*>(user);
    const ExternalFiles::File* file = readable.find(path);
    std::string why = "no such file";
    if (file != nullptr && read_bytes(file->path, readable.bytes_left, *out, why)) {
      readable.bytes_left -= out->size();
      if (file->byte_length != 0 && out->size() > file->byte_length) out->resize(file->byte_length);
      return true;
    }
    if (error) *error += (file != nullptr ? file->uri : path) + ": " + why;
    return false;
  };
  callbacks.user_data = readable;
  return callbacks;
}

}  // namespace

Document read_document(const std::filesystem::path& file, std::size_t max_decoded_bytes) {
  Bytes bytes;
  std::string why;
  if (!read_bytes(file, max_file_bytes, bytes, why)) throw std::runtime_error(file.string() + ": " + why);

  const bool glb = is_glb(bytes);
  const std::string_view text =
      glb ? check_glb(file, bytes)
          : std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  if (text.size() > max_decoded_bytes / max_json_growth)
    refuse(file, "JSON", "is longer than " + std::to_string(max_decoded_bytes / max_json_growth) + " bytes");
  const nlohmann::json original = parse_checked_json(file, text);
  nlohmann::json root = original;
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  Document document{.file = file, .max_decoded_bytes = max_decoded_bytes};
  for (const std::string& warning : fill_tinygltf_gaps(root)) warn(document, warning);
  complete_draco_accessors(root);
  complete_meshopt_buffers(root);
  complete_data_uris(root);
  ReadableFiles readable{replace_file_uris(file, folder, root), max_decoded_bytes};
  if (root != original) bytes = with_json(bytes, root.dump());

  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keep_image_bytes, nullptr);
  reader.SetFsCallbacks(callbacks_for(&readable));
  std::string error, remarks;
  bool loaded = false;
  try {
    const auto size = static_cast<unsigned int>(bytes.size());
    loaded = glb ? reader.LoadBinaryFromMemory(&document.model, &error, &remarks, bytes.data(), size, folder)
                 : reader.LoadASCIIFromString(&document.model, &error, &remarks,
                                              reinterpret_cast<const char*>(bytes.data()), size, folder);
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  // tinygltf also returns true after errors that made it drop a part of the file.
  if (!loaded || !error.empty()) refuse(file, "glTF", error.empty() ? "cannot be parsed" : error);
  for (tinygltf::Image& image : document.model.images)
    if (const ExternalFiles::File* external = readable.find(image.uri)) image.uri = external->uri;
  decode_meshopt_views(document);
  return document;
}

}  // namespace cps::gltf
