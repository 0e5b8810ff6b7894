#pragma once

#include <filesystem>
#include <stdexcept>

namespace cps {

/// Thrown when another process holds what the work needs: try again later.
struct HeldByAnother : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A lock on a file (flock); the file is created if it does not exist. The lock ends with the process that
/// holds it, even if that is killed. On an NFS share Linux asks the server, so it holds between machines too,
/// unless the share is mounted with `nolock` or `local_lock`; the lock of a machine that disappears ends when
/// the server gives it up.
class FileLock {
 public:
  enum class Kind {
    shared,    ///< other processes may hold shared locks
    exclusive  ///< no other process holds a lock
  };

  /// Takes the lock if it is free, otherwise waits for it if `wait` is set, or returns without it: see
  /// is_held(). On a file system without locks it counts as held, with a warning on stderr. Throws
  /// std::runtime_error when the file cannot be opened.
  FileLock(const std::filesystem::path& file, Kind kind, bool wait = false);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  bool is_held() const { return is_held_; }

  /// Releases a shared lock and takes an exclusive one; another process may take the lock in between. Returns
  /// false, with nothing held, when another process has it.
  bool make_exclusive();

  /// The open file: for reading, and for appending.
  int descriptor() const { return descriptor_; }

 private:
  bool take(int operation);

  std::filesystem::path file_;
  int descriptor_ = -1;
  bool is_held_ = false;
};

}  // namespace cps
