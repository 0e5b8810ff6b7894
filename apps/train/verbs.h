#pragma once

#include <string>
#include <vector>

#include "apps/manual/pages.h"

/// The verbs of `cps-train`, one file each, under the same rules as those of `cps` (apps/verbs.h).
namespace cps {

using Arguments = std::vector<std::string>;

extern const Manual train_manual, eval_manual, predict_manual;

int train_verb(const Arguments& arguments);
int eval_verb(const Arguments& arguments);
int predict_verb(const Arguments& arguments);

}  // namespace cps
