#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/journal.h"
#include "production/frame_exposure.h"
#include "production/watch.h"
#include "sampler/plan/plan.h"

namespace cps {

/// CPU seconds of each stage, all threads together.
struct StageTimes {
  double render_s = 0, warp_s = 0, develop_s = 0, encode_s = 0, write_s = 0;
};

struct MakeViewsSummary {
  std::int64_t views = 0, images = 0;
  bool is_interrupted = false;  ///< stopped by its watch before all views were made
  int threads = 1;
  double wall_s = 0, cpu_s = 0;  ///< of everything, loading scenes as well
  StageTimes cpu;
  BadlyExposed badly_exposed;
  std::string brief() const;
};

/// How many views make_views() keeps in memory at a time. While one is rendered the images of the previous
/// ones are made, which is a small part of the work: few are enough.
int views_in_flight(int threads);

/// Renders views (indices into plan.views, in their order) and photographs each through its lenses into
/// files. A view whose files are all written is entered in the journal. While one view is rendered the images
/// of the previous ones are made. The files are the same for any number of threads. Where the watch stops it,
/// and after an error, the view being rendered is given up and those already rendered are completed. Throws
/// the first error, in one line.
MakeViewsSummary make_views(const Plan& plan, const std::vector<std::int64_t>& views, Journal& journal,
                            const std::filesystem::path& root, int threads, const Watch& watch);

}  // namespace cps
