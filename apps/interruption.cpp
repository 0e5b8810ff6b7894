#include "apps/interruption.h"

#include <signal.h>

#include <atomic>
#include <iostream>

#include "files/file_lock.h"

namespace cps {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (int signal : {SIGTERM, SIGINT}) sigaction(signal, &action, nullptr);
}

}  // namespace

int run_interruptible(const std::string& name, const std::function<int()>& work) {
  stop_on_signals();
  try {
    return work();
  } catch (const Interrupted&) {
    std::cout << name << ": interrupted; run the same command again to go on\n";
    return exit_run_again;
  } catch (const HeldByAnother& error) {
    std::cerr << "cps: " << error.what() << "\n";
    return exit_run_again;
  }
}

Watch interruptible_watch() {
  return {.must_stop = [] { return interrupted.load(); },
          .note = [](const std::string& line) { std::cout << line << "\n"; },
          .warn = [](const std::string& line) { std::cerr << line << "\n"; }};
}

}  // namespace cps
