#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX

/// Files that are too large to hold in memory: writing and hashing them piece by piece.
namespace cps {

/// Takes the next bytes of a file. Throws std::runtime_error with the cause when they cannot be written.
using Append = std::function<void(std::span<const char>)>;

/// As write_file() of files.h does, with the bytes that `produce` appends.
void write_in_pieces(const std::filesystem::path& file, const std::function<void(const Append&)>& produce);

/// SHA-256 of bytes that come in pieces. Throws std::runtime_error where OpenSSL has none.
class Sha256 {
 public:
  Sha256();
  void add(std::span<const char> bytes);
  /// In lower-case hex; the last thing to ask.
  std::string hex();

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

/// SHA-256 of a file in lower-case hex. Throws std::runtime_error naming it when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace cps
