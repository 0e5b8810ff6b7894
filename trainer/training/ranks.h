#pragma once

#include <memory>

namespace at {
class Tensor;
}

namespace cps {

/// The processes that train one network together. With one, nothing is ever sent.
class Ranks {
 public:
  /// One process.
  Ranks();
  ~Ranks();
  Ranks(Ranks&&) noexcept;
  Ranks& operator=(Ranks&&) noexcept;

  int rank = 0, count = 1;

  /// The sum over all processes, in place, the same bits on each. Contiguous floats or doubles, on any device
  /// (they are sent from the CPU). Throws
  /// std::runtime_error when another process is gone.
  void sum(at::Tensor& tensor) const;

  /// The same of one number.
  double sum(double number) const;

  /// Waits until all are here.
  void wait() const;

 private:
  friend Ranks join_ranks();
  struct Group;
  std::unique_ptr<Group> group_;
};

/// Joins the processes that the environment names, as torchrun sets it: RANK, WORLD_SIZE, MASTER_ADDR,
/// MASTER_PORT (29500). Under srun none need be set: SLURM_PROCID, SLURM_STEP_NUM_TASKS and
/// slurm_meeting_point() say the same. Gloo over TCP; CPS_NETWORK_INTERFACE names the network interface, else
/// it is the loopback when rank 0 is at 127.0.0.1, and that of this machine's name when it is not. One
/// process without these variables. Throws std::runtime_error with one line when one makes no sense or the
/// others cannot be reached.
Ranks join_ranks();

}  // namespace cps
