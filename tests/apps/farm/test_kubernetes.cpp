#include <yaml-cpp/yaml.h>

#include "files/files.h"
#include "tests/apps/farm/shard_command.h"

using namespace cps;

namespace {

YAML::Node job(const char* name) {
  return YAML::LoadFile(CPS_SOURCE "/apps/kubernetes/" + std::string(name) + ".yaml");
}

/// The rule that decides about an exit status: the first that names it.
std::string action_for(const YAML::Node& spec, int status) {
  for (const YAML::Node& rule : spec["podFailurePolicy"]["rules"]) {
    if (!rule["onExitCodes"]) continue;
    for (const YAML::Node& value : rule["onExitCodes"]["values"])
      if (value.as<int>() == status) return rule["action"].as<std::string>();
  }
  return "Count";  // Kubernetes' default
}

/// What the API server demands of every failure policy.
void check_policy(const YAML::Node& spec) {
  const YAML::Node pod = spec["template"]["spec"];
  CHECK(pod["restartPolicy"].as<std::string>() == "Never");
  const auto container = pod["containers"][0]["name"].as<std::string>();
  for (const YAML::Node& rule : spec["podFailurePolicy"]["rules"]) {
    CHECK(bool(rule["onExitCodes"]) != bool(rule["onPodConditions"]));
    if (!rule["onExitCodes"]) continue;
    CHECK(rule["onExitCodes"]["containerName"].as<std::string>() == container);
    CHECK(rule["onExitCodes"]["operator"].as<std::string>() == "In");
    int before = 0;  // values ascend, and 0 is none of them
    for (const YAML::Node& value : rule["onExitCodes"]["values"]) {
      CHECK(value.as<int>() > before);
      before = value.as<int>();
    }
  }
  CHECK(spec["podFailurePolicy"]["rules"][0]["onPodConditions"][0]["type"].as<std::string>() ==
        "DisruptionTarget");
  CHECK(spec["podFailurePolicy"]["rules"][0]["action"].as<std::string>() == "Ignore");
}

/// The command that a pod's shell gets, as one text.
std::string command_of(const YAML::Node& container) {
  REQUIRE(container["command"].as<std::vector<std::string>>() == std::vector<std::string>{"sh", "-c"});
  REQUIRE(container["args"].size() == 1);
  return container["args"][0].as<std::string>();
}

}  // namespace

TEST_CASE("Kubernetes' job gives each index its shard, runs 75 again and gives up on 2") {
  const YAML::Node spec = job("cps-generate")["spec"];
  CHECK(spec["completionMode"].as<std::string>() == "Indexed");
  CHECK(spec["backoffLimitPerIndex"].as<int>() > 0);  // FailIndex needs it
  check_policy(spec);
  CHECK(action_for(spec, 75) == "Ignore");
  CHECK(action_for(spec, 2) == "FailIndex");
  CHECK(action_for(spec, 1) == "Count");
  CHECK(action_for(spec, 137) == "Count");

  const YAML::Node container = spec["template"]["spec"]["containers"][0];
  const auto shards = spec["completions"].as<std::string>();
  std::map<std::string, std::string> environment;
  for (const YAML::Node& variable : container["env"])
    environment[variable["name"].as<std::string>()] =
        variable["value"] ? variable["value"].as<std::string>() : "16";
  CHECK(environment.at("CPS_SHARDS") == shards);
  check_shards(command_of(container), "JOB_COMPLETION_INDEX", environment, std::stoi(shards));
}

TEST_CASE("Kubernetes' last job finishes and verifies the folder that the first one fills") {
  const YAML::Node spec = job("cps-finish")["spec"];
  check_policy(spec);
  CHECK(action_for(spec, 75) == "Ignore");
  CHECK(action_for(spec, 1) == "FailJob");
  CHECK(action_for(spec, 2) == "FailJob");
  const YAML::Node container = spec["template"]["spec"]["containers"][0],
                   first = job("cps-generate")["spec"]["template"]["spec"]["containers"][0];
  CHECK(container["image"].as<std::string>() == first["image"].as<std::string>());
  check_finish(command_of(container), command_of(first));
}
