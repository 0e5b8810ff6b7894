#include "files/data_uri.h"

#include <openssl/evp.h>

namespace cps {

std::string data_uri(const std::string& media_type, std::span<const char> bytes) {
  std::string base64(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // with a final zero
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(base64.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  base64.resize(static_cast<std::size_t>(length));
  return "data:" + media_type + ";base64," + base64;
}

}  // namespace cps
