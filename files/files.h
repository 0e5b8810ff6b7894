#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

/// Reading and writing whole files. Everything the dataset consists of appears by atomic rename: a file under
/// its final name is complete, whenever the program was killed.
namespace cps {

/// The file's bytes. Throws std::runtime_error naming it.
std::string read_file(const std::filesystem::path& file);

/// The file as JSON. Throws std::runtime_error naming file and position.
nlohmann::json read_json(const std::filesystem::path& file);

/// Writes to a temporary name beside `file`, waits until the bytes are on the disk, then renames; makes the
/// folders above it. Any number of processes may write one file. Throws std::runtime_error naming file and
/// cause and leaves nothing behind.
void write_file(const std::filesystem::path& file, std::span<const char> bytes);

/// The same for what can only be written to a named file: `write` gets the temporary name and throws when it
/// fails.
void write_by_rename(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// Removes what write_file left half-written under temporary names in `folder` (not below it) when it was
/// killed. Not while another process may be writing there.
void remove_temporaries(const std::filesystem::path& folder);

/// Indented JSON with a final newline.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

/// SHA-256 in lower-case hex.
std::string sha256(std::span<const char> bytes);

}  // namespace cps
