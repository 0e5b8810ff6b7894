#include "dataset/files.h"

#include <openssl/evp.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace cps {

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
  const std::filesystem::path temporary = file.string() + "." + std::to_string(getpid()) + ".tmp";
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
  write_by_rename(file, [&](const std::filesystem::path& temporary) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw std::runtime_error(std::strerror(errno));
  });
}

void remove_temporaries(const std::filesystem::path& folder) {
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".tmp") std::filesystem::remove(entry.path());
}

void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json) {
  write_file(file, json.dump(2) + "\n");
}

std::string sha256(std::span<const char> bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in this build of OpenSSL");
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    constexpr char digits[] = "0123456789abcdef";
    hex += {digits[digest[i] >> 4], digits[digest[i] & 15]};
  }
  return hex;
}

}  // namespace cps
