#pragma once

#include "apps/manual/manual.h"

/// Names and summaries of the verbs of `cps-train`, which `cps` lists, too.
namespace cps {

inline const Manual::Line train_line{"train", "train a network on a dataset"};
inline const Manual::Line eval_line{"eval", "measure a trained network on a dataset"};
inline const Manual::Line predict_line{"predict", "run a trained network on pictures"};

}  // namespace cps
