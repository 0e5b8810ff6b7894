#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "files/files.h"
#include "sampler/plan/shard.h"
#include "tests/apps/cps_program.h"
#include "tests/temporary_folder.h"

/// Commands of farm managers, run by a shell as in a container, with a `cps` that notes how it was called.
namespace cps {

/// The calls of `cps` that a shell command makes, the words of each in <>, one call a line.
inline std::string calls_of(const std::string& command,
                            const std::map<std::string, std::string>& environment) {
  const TemporaryFolder folder;
  const std::filesystem::path program = folder.path / "cps", calls = folder.path / "calls",
                              script = folder.path / "command";
  write_file(program, "#!/bin/sh\n{ printf '<%s>' \"$@\"; echo; } >> " + calls.string() + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  write_file(script, command);
  std::string run = "env -i PATH=" + folder.path.string() + ":/usr/bin:/bin";
  for (const auto& [name, value] : environment) run += " " + name + "=" + value;
  REQUIRE(std::system((run + " sh -c \"$(cat " + script.string() + ")\"").c_str()) == 0);
  return read_file(calls);
}

/// The word after an option in such a call.
inline std::string value_in(const std::string& call, const std::string& option) {
  const std::string before = "<" + option + "><";
  const std::size_t start = call.find(before);
  INFO(call);
  REQUIRE(start != call.npos);
  return call.substr(start + before.size(), call.find('>', start + before.size()) - start - before.size());
}

/// The command makes shard I of N where the manager numbers the job I, and cps generate accepts all it says.
inline void check_shards(const std::string& command, const std::string& index_variable,
                         std::map<std::string, std::string> environment, int shards) {
  CHECK_THAT(command, Catch::StartsWith("exec cps generate "));
  for (const int index : {0, 1, shards - 1}) {
    environment[index_variable] = std::to_string(index);
    const std::string call = calls_of(command, environment);
    const Shard shard = shard_from_string(value_in(call, "--shard"));
    CHECK(shard.index == index);
    CHECK(shard.count == shards);
    CHECK(std::stoi(value_in(call, "--threads")) >= 1);
    // A scene that is not there stops cps after it has read its options, before it writes anything.
    const TemporaryFolder folder;
    std::string arguments = std::regex_replace(call.substr(0, call.find('\n')), std::regex("><"), " ");
    arguments = std::regex_replace(arguments, std::regex("[<>]"), "");
    arguments = std::regex_replace(arguments, std::regex("/data/"), folder.path.string() + "/");
    check_refused(arguments + " --scene /nonexistent.glb", 1, "/nonexistent.glb: there is no such file");
  }
}

/// The command finishes, and then verifies, the folder that the shards' command fills.
inline void check_finish(const std::string& command, const std::string& shards_command) {
  const std::string out = value_in(calls_of(shards_command, {}), "--out");
  CHECK(calls_of(command, {}) == "<finish><" + out + ">\n<verify><" + out + ">\n");
}

}  // namespace cps
