#include "apps/pictures/dpx_header.h"

#include <array>
#include <cstdint>
#include <fstream>

#include "apps/pictures/picture_format.h"

namespace cps {

void check_dpx_header(const std::filesystem::path& file) {
  constexpr std::size_t user_size_at = 32;
  constexpr std::uint32_t undefined = 0xffffffff;
  std::array<unsigned char, user_size_at + 4> header{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(header.data()), header.size())) return;
  const std::string magic(header.begin(), header.begin() + 4);
  if (magic != "SDPX" && magic != "XPDS") return;
  std::uint32_t user_bytes = 0;
  for (std::size_t i = 0; i < 4; ++i)
    user_bytes = user_bytes << 8 | header[user_size_at + (magic == "SDPX" ? i : 3 - i)];
  if (user_bytes != undefined && user_bytes > std::filesystem::file_size(file))
    refuse_picture(file, "is damaged: its header announces " + std::to_string(user_bytes) +
                             " bytes of user data, more than the file has");
}

}  // namespace cps
