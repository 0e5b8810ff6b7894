#include <catch2/catch.hpp>

#include "tests/environment_variables.h"
#include "trainer/training/slurm_step.h"

using namespace cps;

TEST_CASE("the first node of Slurm's lists") {
  CHECK(first_node("") == "");
  CHECK(first_node("node1") == "node1");
  CHECK(first_node("fat1,node[1-3]") == "fat1");
  CHECK(first_node("gpu[07-12,20]-ib,fat1") == "gpu07-ib");
  CHECK(first_node("r[2,4]n[11-12]") == "r2n11");
  CHECK(first_node("eu-west-[3]") == "eu-west-3");
}

TEST_CASE("processes of one Slurm step meet at one place, those of another elsewhere") {
  CHECK(slurm_meeting_point().host == "");
  const EnvironmentVariables job{{"SLURM_JOB_ID", "4294967000"}, {"SLURM_LAUNCH_NODE_IPADDR", "192.0.2.7"}};
  int port = 0;
  {
    const EnvironmentVariables step{
        {"SLURM_STEP_ID", "0"}, {"SLURM_STEP_NUM_NODES", "1"}, {"SLURM_STEP_NODELIST", "no-such-node"}};
    const MeetingPoint point = slurm_meeting_point();
    CHECK(point.host == "127.0.0.1");
    CHECK(point.port >= 20000);
    CHECK(point.port < 30000);
    port = point.port;
  }
  {
    const EnvironmentVariables step{
        {"SLURM_STEP_ID", "1"}, {"SLURM_STEP_NUM_NODES", "2"}, {"SLURM_STEP_NODELIST", "localhost,other"}};
    CHECK(slurm_meeting_point().host == "localhost");
    CHECK(slurm_meeting_point().port != port);
  }
  {
    const EnvironmentVariables step{{"SLURM_STEP_ID", "0"},
                                    {"SLURM_STEP_NUM_NODES", "2"},
                                    {"SLURM_STEP_NODELIST", "no-such-node.invalid,other"}};
    CHECK(slurm_meeting_point().host == "192.0.2.7");
  }
}
