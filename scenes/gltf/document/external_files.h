#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cps::gltf {

/// The files that a glTF file names. tinygltf would read "a+b.png" as "a b.png" and refuse a buffer's file
/// that is longer than the buffer, which glTF allows; so it sees stand-in names.
struct ExternalFiles {
  struct File {
    std::filesystem::path path;
    std::string uri;              ///< as the glTF file writes it
    std::size_t byte_length = 0;  ///< of the buffer; 0: the whole file
  };
  std::map<std::string, File> by_stand_in = {};  ///< "buffers-0", "images-3", …
};

/// Replaces the URIs of buffers and images that name files in `folder`. Refuses a buffer whose file is not
/// there.
ExternalFiles replace_file_uris(const std::filesystem::path& gltf_file, const std::filesystem::path& folder,
                                nlohmann::json& root);

}  // namespace cps::gltf
