#include "files/pieces.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "files/files.h"

namespace cps {
namespace {

/// A file that is being written. The functions throw std::runtime_error with the cause.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& file)
      : descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) throw std::runtime_error(std::strerror(errno));
  }
  ~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void append(std::span<const char> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) throw std::runtime_error(std::strerror(errno));
      if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  void close() {
    // Renamed before its bytes are on the disk, a file could be empty under its final name after a power cut.
    if (fdatasync(descriptor_) != 0 && errno != EINVAL) throw std::runtime_error(std::strerror(errno));
    if (::close(std::exchange(descriptor_, -1)) != 0) throw std::runtime_error(std::strerror(errno));
  }

 private:
  int descriptor_;
};

}  // namespace

void write_in_pieces(const std::filesystem::path& file, const std::function<void(const Append&)>& produce) {
  write_by_rename(file, [&](const std::filesystem::path& temporary) {
    NewFile out(temporary);
    produce([&](std::span<const char> bytes) { out.append(bytes); });
    out.close();
  });
}

Sha256::Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
  if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in this build of OpenSSL");
}

void Sha256::add(std::span<const char> bytes) {
  if (EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) != 1)
    throw std::runtime_error("SHA-256 failed in this build of OpenSSL");
}

std::string Sha256::hex() {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_DigestFinal_ex(context_.get(), digest, &size) != 1)
    throw std::runtime_error("SHA-256 failed in this build of OpenSSL");
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    constexpr char digits[] = "0123456789abcdef";
    hex += {digits[digest[i] >> 4], digits[digest[i] & 15]};
  }
  return hex;
}

std::string sha256_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Sha256 hash;
  std::vector<char> piece(1 << 20);
  while (stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.add({piece.data(), static_cast<std::size_t>(stream.gcount())});
  }
  if (!stream.eof()) throw std::runtime_error(file.string() + ": cannot be read: " + std::strerror(errno));
  return hash.hex();
}

}  // namespace cps
