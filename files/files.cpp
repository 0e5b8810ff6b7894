#include "files/files.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <stdexcept>

#include "files/pieces.h"

namespace cps {
namespace {

constexpr std::string_view temporary_ending = ".tmp";
constexpr std::size_t process_digits = 8;

/// `<file>.<process>-<count>.tmp`, both numbers in hexadecimal: differs between all threads of all processes
/// of all machines that write to one folder. The process is a random number.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
  static const unsigned process = std::random_device()();
  static std::atomic<unsigned> count = 0;
  return fmt::format("{}.{:08x}-{:x}{}", file.string(), process, count++, temporary_ending);
}

/// Whether temporary_name() could have made it.
bool is_temporary_name(std::string_view name) {
  if (!name.ends_with(temporary_ending)) return false;
  name.remove_suffix(temporary_ending.size());
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos || dot == 0) return false;
  const std::string_view unique = name.substr(dot + 1);
  const auto are_digits = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789abcdef") == text.npos;
  };
  return unique.find('-') == process_digits && are_digits(unique.substr(0, process_digits)) &&
         are_digits(unique.substr(process_digits + 1));
}

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read: " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(stream), {}};
}

nlohmann::json read_json(const std::filesystem::path& file) {
  try {
    return nlohmann::json::parse(read_file(file));
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file.string() + ": is not JSON: " + error.what());
  }
}

void write_by_rename(const std::filesystem::path& file,
                     const std::function<void(const std::filesystem::path& temporary)>& write) {
  const std::filesystem::path temporary = temporary_name(file);
  try {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    write(temporary);
    std::filesystem::rename(temporary, file);
  } catch (const std::exception& error) {
    const auto* file_error = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    const std::string cause = file_error ? file_error->code().message() : error.what();
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::runtime_error(file.string() + ": cannot be written: " + cause);
  }
}

void write_file(const std::filesystem::path& file, std::span<const char> bytes) {
  write_in_pieces(file, [&](const Append& append) { append(bytes); });
}

void remove_temporaries(const std::filesystem::path& folder) {
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && is_temporary_name(entry.path().filename().string()))
      std::filesystem::remove(entry.path());
}

void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json) {
  write_file(file, json.dump(2) + "\n");
}

std::string sha256(std::span<const char> bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hex();
}

}  // namespace cps
