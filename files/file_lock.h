#pragma once

#include <filesystem>
#include <stdexcept>

namespace cps {

/// Thrown where work cannot be done now because another process holds what it needs: to be tried again later.
struct HeldByAnother : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A lock on a file (flock), made if it is not there, that goes with the process that holds it, however that
/// ends. Linux passes it on to the server of an NFS share, so it holds between machines too, unless the share
/// is mounted with `nolock` or `local_lock`; of a machine that goes away it is released when the server gives
/// it up.
class FileLock {
 public:
  enum class Kind {
    shared,    ///< with other shared ones
    exclusive  ///< alone
  };

  /// Takes the lock if it is free; `wait` for it or look at is_held(). Where the file system knows no locks
  /// it counts as held, and one line on stderr says so. Throws std::runtime_error when the file cannot be
  /// opened.
  FileLock(const std::filesystem::path& file, Kind kind, bool wait = false);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_held() const { return is_held_; }

  /// Gives a shared lock up for an exclusive one; between the two another process may come. False, and
  /// nothing is held, when another process holds it.
  bool make_exclusive();

  /// For reading and writing, at the file's end.
  int descriptor() const { return descriptor_; }

 private:
  bool take(int operation);

  std::filesystem::path file_;
  int descriptor_ = -1;
  bool is_held_ = false;
};

}  // namespace cps
