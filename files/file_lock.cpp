#include "files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace cps {

FileLock::FileLock(const std::filesystem::path& file, Kind kind, bool wait) : file_(file) {
  std::error_code failed;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failed);
  if (failed) throw std::runtime_error(file.string() + ": cannot be written: " + failed.message());
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
  is_held_ = take((kind == Kind::shared ? LOCK_SH : LOCK_EX) | (wait ? 0 : LOCK_NB));
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool FileLock::make_exclusive() {
  flock(descriptor_, LOCK_UN);
  return is_held_ = take(LOCK_EX | LOCK_NB);
}

bool FileLock::take(int operation) {
  while (flock(descriptor_, operation) != 0) {
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK) return false;
    std::fprintf(stderr, "%s: cannot be locked (%s): make sure that no two processes make the same shard\n",
                 file_.c_str(), std::strerror(errno));
    return true;
  }
  return true;
}

}  // namespace cps
