#pragma once

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace cps {

/// What a command prints, stdout and stderr together. It must succeed.
inline std::string output_of(const std::string& command) {
  std::string output;
  FILE* pipe = popen(("( " + command + " ) 2>&1").c_str(), "r");
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, n);
  const int status = pclose(pipe);
  INFO(command << "\n" << output);
  REQUIRE(status == 0);
  return output;
}

/// The same of a program, which is asked once: cps-train takes a second to start.
inline const std::string& program_output(const std::string& program, const std::string& arguments) {
  static std::map<std::string, std::string> known;
  const std::string command = program + " " + arguments;
  if (known.count(command) == 0) known[command] = output_of(command);
  return known[command];
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// cps, and cps-train where it is built.
inline std::vector<std::string> built_programs() {
  std::vector<std::string> programs{CPS_PROGRAM};
  if (const std::string trainer = CPS_BUILD "/bin/cps-train"; std::filesystem::exists(trainer))
    programs.push_back(trainer);
  return programs;
}

/// Every page that the program prints, by name.
inline std::vector<std::string> pages_of(const std::string& program) {
  return lines_of(program_output(program, "--man"));
}

/// A page's verb as it is typed: "lens check" for cps-lens-check.
inline std::string verb_of_page(const std::string& page) {
  if (page == "cps") return "";
  const std::string verb = page.substr(page.find('-') + 1);
  const std::string lens = "lens-";
  return verb.starts_with(lens) ? "lens " + verb.substr(lens.size()) : verb;
}

/// The long options that a verb's help lists, with their dashes.
inline std::vector<std::string> options_in_help(const std::string& program, const std::string& verb) {
  std::vector<std::string> options;
  for (const std::string& line : lines_of(program_output(program, verb + " --help"))) {
    const bool has_letter = line.size() > 5 && line.starts_with("  -") && line[4] == ',';
    if (!has_letter && !line.starts_with("      --")) continue;
    const std::size_t start = line.find("--");
    options.push_back(line.substr(start, line.find(' ', start) - start));
  }
  return options;
}

}  // namespace cps
