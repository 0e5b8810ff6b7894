#pragma once

#include <string>
#include <string_view>

namespace cps {

/// The address at which the processes of a Slurm job step reach their rank 0.
struct MeetingPoint {
  std::string host;
  int port = 0;
};

/// Derives the meeting point from the variables that srun sets for every process of a step
/// (SLURM_STEP_NODELIST, SLURM_STEP_NUM_NODES, SLURM_JOB_ID, SLURM_STEP_ID, SLURM_LAUNCH_NODE_IPADDR). The
/// host is the step's first node, where rank 0 runs, or the loopback if there is only one. The port is
/// 20000…29999 and differs between steps and jobs that may share a node. If this machine cannot resolve the
/// node's name, the node is assumed to be the one that started srun, as in a batch script. Outside a step the
/// host is empty.
MeetingPoint slurm_meeting_point();

/// The first node of a list in Slurm's notation: "gpu07-ib" for "gpu[07-12,20]-ib,fat1".
std::string first_node(std::string_view node_list);

}  // namespace cps
