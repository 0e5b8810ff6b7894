#pragma once

#include "dataset/verify/dataset_files.h"

namespace cps {

/// Checks every listed image: present, of the label's size, decodable; its SHA-256 against frames.csv and the
/// pixel hash of its list against dataset.json, where there are any.
void check_images(const DatasetFiles& files, Faults& faults);

/// Checks every kept master: present, decodable, SHA-256 and size as masters.csv says. Returns their number.
std::int64_t check_masters(const DatasetFiles& files, Faults& faults);

}  // namespace cps
