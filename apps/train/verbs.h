#pragma once

#include <string>
#include <vector>

/// The verbs of `cps-train`, one file each, under the same rules as those of `cps` (apps/verbs.h).
namespace cps {

using Arguments = std::vector<std::string>;

int train_verb(const Arguments& arguments);
int eval_verb(const Arguments& arguments);
int predict_verb(const Arguments& arguments);

}  // namespace cps
