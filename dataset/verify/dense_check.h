#pragma once

#include "dataset/verify/dataset_files.h"

namespace cps {

/// Checks the dense labels of every listed image: the files that the recipe asks for and no others, SHA-256
/// as in frames.csv, decodable, of the image's size. What can be computed again is: rays, up and latitude
/// from label and pose; distance against depth, and normals against the direction they are seen from.
/// Instance and semantic pixels hold only numbers that dataset.json knows. Returns the number of files.
std::int64_t check_dense(const DatasetFiles& files, Faults& faults);

}  // namespace cps
