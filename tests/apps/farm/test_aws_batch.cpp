#include <nlohmann/json.hpp>

#include "files/files.h"
#include "tests/apps/farm/shard_command.h"

using namespace cps;
using nlohmann::json;

namespace {

json file(const char* name) {
  return json::parse(read_file(CPS_SOURCE "/apps/aws-batch/" + std::string(name) + ".json"));
}

/// What Batch does after an attempt, as its manual says: patterns may end with *, the first condition that
/// holds decides, and a job that no condition is about is run again.
std::string action_for(const json& strategy, const std::string& exit_code, const std::string& status_reason) {
  const auto matches = [](const json& condition, const char* key, const std::string& text) {
    if (!condition.contains(key)) return true;
    std::string pattern = condition.at(key);
    if (!pattern.ends_with("*")) return pattern == text;
    pattern.pop_back();
    return text.starts_with(pattern);
  };
  for (const json& condition : strategy.at("evaluateOnExit"))
    if (matches(condition, "onExitCode", exit_code) && matches(condition, "onStatusReason", status_reason))
      return condition.at("action");
  return "RETRY";
}

std::string command_of(const json& request) {
  const json& words = request.at("containerOverrides").at("command");
  REQUIRE(words.size() == 3);
  REQUIRE((words[0] == "sh" && words[1] == "-c"));
  return words[2];
}

}  // namespace

TEST_CASE("AWS Batch runs 75, killed and lost jobs again, and gives up on 1 and 2") {
  const json strategy = file("job-definition").at("retryStrategy");
  CHECK(strategy.at("attempts") == 10);  // the most that Batch allows
  CHECK(strategy.at("evaluateOnExit").size() <= 5);
  const std::string ended = "Essential container in task exited";
  CHECK(action_for(strategy, "75", ended) == "RETRY");
  CHECK(action_for(strategy, "137", ended) == "RETRY");
  CHECK(action_for(strategy, "", "Host EC2 (instance i-0) terminated.") == "RETRY");
  CHECK(action_for(strategy, "1", ended) == "EXIT");
  CHECK(action_for(strategy, "2", ended) == "EXIT");
}

TEST_CASE("AWS Batch's array gives each job its shard") {
  const json request = file("generate");
  CHECK(request.at("jobDefinition") == file("job-definition").at("jobDefinitionName"));
  const int shards = request.at("arrayProperties").at("size");
  CHECK((shards >= 2 && shards <= 10'000));
  std::map<std::string, std::string> environment;
  for (const json& variable : request.at("containerOverrides").at("environment"))
    environment[variable.at("name")] = variable.at("value");
  CHECK(environment.at("CPS_SHARDS") == std::to_string(shards));
  for (const json& resource : file("job-definition").at("containerProperties").at("resourceRequirements"))
    if (resource.at("type") == "VCPU") CHECK(resource.at("value") == environment.at("CPS_THREADS"));
  check_shards(command_of(request), "AWS_BATCH_JOB_ARRAY_INDEX", environment, shards);
}

TEST_CASE("AWS Batch's last job finishes and verifies the folder that the array fills") {
  const json request = file("finish");
  CHECK(request.at("jobDefinition") == file("job-definition").at("jobDefinitionName"));
  CHECK(request.at("jobQueue") == file("generate").at("jobQueue"));
  check_finish(command_of(request), command_of(file("generate")));
}
