#pragma once

#include <memory>

namespace at {
class Tensor;
}

namespace cps {

/// The processes that train one network together. With one process, nothing is sent.
class Ranks {
 public:
  /// A single process.
  Ranks();
  ~Ranks();
  Ranks(Ranks&&) noexcept;
  Ranks& operator=(Ranks&&) noexcept;

  int rank = 0, count = 1;

  /// Replaces the tensor by its sum over all processes, with the same bits on each. It must be contiguous
  /// floats or doubles, on any device (they are sent from the CPU). Throws std::runtime_error if another
  /// process is gone.
  void sum(at::Tensor& tensor) const;

  /// The sum of one number over all processes.
  double sum(double number) const;

  /// Waits until all processes have called this.
  void wait() const;

 private:
  friend Ranks join_ranks();
  struct Group;
  std::unique_ptr<Group> group_;
};

/// Joins the group of processes that the environment describes, with torchrun's variables: RANK, WORLD_SIZE,
/// MASTER_ADDR, MASTER_PORT (default 29500). Under srun they need not be set: SLURM_PROCID,
/// SLURM_STEP_NUM_TASKS and slurm_meeting_point() replace them. Without any, returns a single process.
/// Communicates by Gloo over TCP. CPS_NETWORK_INTERFACE names the network interface; by default it is the
/// loopback if rank 0 is at 127.0.0.1, else the interface of this machine's host name. Throws
/// std::runtime_error with one line if a variable is invalid or another process cannot be reached.
Ranks join_ranks();

}  // namespace cps
