#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

/// Reading and writing whole files. Files appear by atomic rename: a file under its final name is complete,
/// even if the program was killed while writing it.
namespace cps {

/// The file's bytes. Throws std::runtime_error naming it.
std::string read_file(const std::filesystem::path& file);

/// The file as JSON. Throws std::runtime_error naming file and position.
nlohmann::json read_json(const std::filesystem::path& file);

/// Writes to a temporary name beside `file`, waits until the bytes are on the disk, then renames; makes the
/// folders above it. Several processes may write the same file at once. Throws std::runtime_error naming file
/// and cause, and then leaves no temporary file behind.
void write_file(const std::filesystem::path& file, std::span<const char> bytes);

/// The same for writers that need a file name: `write` gets the temporary name and throws when it fails. Does
/// not wait for the disk.
void write_by_rename(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// Removes the temporary files that a killed write_file or write_by_rename left in `folder` (not below it),
/// and nothing else. Call it only when no other process may be writing there.
void remove_temporaries(const std::filesystem::path& folder);

/// Indented JSON with a final newline.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

/// SHA-256 in lower-case hex.
std::string sha256(std::span<const char> bytes);

}  // namespace cps
