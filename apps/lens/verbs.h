#pragma once

#include "apps/verbs.h"

/// The verbs of `cps lens`, one file each; contract as in apps/verbs.h.
namespace cps {

extern const Manual lens_limits_manual, lens_check_manual, lens_convert_manual, lens_sample_manual;

int cps_lens_limits(const Arguments& arguments);
int cps_lens_check(const Arguments& arguments);
int cps_lens_convert(const Arguments& arguments);
int cps_lens_sample(const Arguments& arguments);

}  // namespace cps
