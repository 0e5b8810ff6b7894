#pragma once

#include <functional>
#include <string>

#include "production/watch.h"

namespace cps {

/// Exit status of a command that stopped before it was done and continues when it is run again (EX_TEMPFAIL
/// of sysexits.h; Slurm's RequeueExit can name it).
inline constexpr int exit_run_again = 75;

/// Runs the work and returns its exit status. The first SIGTERM or SIGINT meanwhile only sets a flag, the
/// second one kills the process. Where the work then throws Interrupted, prints that `name` was interrupted
/// and returns exit_run_again; likewise where another process holds what the work needs (HeldByAnother).
int run_interruptible(const std::string& name, const std::function<int()>& work);

/// A watch that stops work once such a signal came, and prints notes on stdout and warnings on stderr.
Watch interruptible_watch();

}  // namespace cps
