#include "trainer/atomic_file.h"

#include <fstream>
#include <stdexcept>

namespace cps {

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
  const std::filesystem::path partial = file.string() + ".part";
  std::ofstream out(partial, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw std::runtime_error(file.string() + ": cannot be written: check the folder's rights and free space");
  }
  std::filesystem::rename(partial, file);
}

}  // namespace cps
