#pragma once

#include <exception>
#include <functional>
#include <string>

namespace cps {

/// Exit status of what was asked to stop before it was done and goes on when it is run again (EX_TEMPFAIL of
/// sysexits.h; Slurm's RequeueExit knows it).
inline constexpr int exit_run_again = 75;

/// Thrown where long work gives up because it was asked to.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Does the work and returns its exit status. Meanwhile the first SIGTERM or SIGINT only sets a flag, a
/// second one kills as ever; where the work gives up for it (Interrupted), says so of `name` and returns
/// exit_run_again. So it does where another process holds what the work needs (HeldByAnother).
int run_interruptible(const std::string& name, const std::function<int()>& work);

/// Whether such a signal came.
bool is_interrupted();

}  // namespace cps
