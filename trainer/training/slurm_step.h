#pragma once

#include <string>
#include <string_view>

namespace cps {

/// Where the processes of a Slurm job step look for their rank 0.
struct MeetingPoint {
  std::string host;
  int port = 0;
};

/// The meeting point that follows from what srun tells every process of a step (SLURM_STEP_NODELIST,
/// SLURM_STEP_NUM_NODES, SLURM_JOB_ID, SLURM_STEP_ID, SLURM_LAUNCH_NODE_IPADDR): its first node, where rank 0
/// runs, or the loopback if it has no other; a port of 20000 … 29999, which differs between the steps and
/// jobs that may share a node. A node whose name this machine cannot resolve is taken to be the one srun was
/// started on, as it is in a batch script. No host outside a step.
MeetingPoint slurm_meeting_point();

/// The first of a list of nodes as Slurm writes it: "gpu[07-12,20]-ib,fat1" begins with "gpu07-ib".
std::string first_node(std::string_view node_list);

}  // namespace cps
