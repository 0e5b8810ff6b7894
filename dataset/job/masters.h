#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dataset/job/records.h"
#include "distortion/pinhole.h"
#include "sampler/plan/plan.h"

/// The masters that a dataset keeps when its recipe says keep_masters = true: files
/// masters/<set>/<camera>_<place>.exr, listed in masters.csv.
namespace cps {

struct KeptMaster {
  std::filesystem::path file;  ///< relative to the dataset
  Part part = Part::train;
  Pinhole camera;       ///< of the master: oversampled, with the warp's pad
  Pinhole base;         ///< output-sized, centred; lenses drawn later must be certified on its frame
  Pinhole set;          ///< like base, with the H-FOV in the set's name
  double exposure = 1;  ///< metered
  std::string sha256;   ///< of the file
};

/// `masters/1392x512_hfov090/front_000017.exr`.
std::string master_file_name(const Plan& plan, const PlannedView& view);

/// The text of masters.csv: a line for each view, in the plan's order.
std::string masters_csv(const Plan& plan, const std::map<std::int64_t, ViewRecord>& records);

/// The masters of a dataset, in the order of masters.csv. Throws std::runtime_error with one line (file,
/// line, column, fix); also when the dataset keeps none.
std::vector<KeptMaster> read_masters(const std::filesystem::path& dataset);

}  // namespace cps
