#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sampler/plan/plan.h"

namespace cps {

/// Compares a finished dataset with its plan, made again: every calibration.json to the byte, in the form of
/// any schema, and in every line of every frames.csv the columns that the plan decides (part, condition,
/// street, poses, and gravity if it has it). One line per fault, file first.
std::vector<std::string> faults_against_plan(const std::filesystem::path& root, const Plan& plan);

}  // namespace cps
