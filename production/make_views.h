#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/journal.h"
#include "production/progress.h"
#include "sampler/plan/plan.h"

namespace cps {

/// CPU seconds by what they were spent on.
struct StageTimes {
  double render_s = 0, warp_s = 0, develop_s = 0, encode_s = 0, write_s = 0;
};

struct MakeViewsSummary {
  std::int64_t views = 0, images = 0;
  bool is_interrupted = false;  ///< a signal came before all views were made
  int threads = 1;
  double wall_s = 0, cpu_s = 0;  ///< of everything, loading scenes as well
  StageTimes cpu;
  std::string brief() const;
};

/// How many views make_views has in memory at a time. One is rendered while the images of others are made,
/// which is a small part of the work: a few are enough.
int views_in_flight(int threads);

/// Renders views (indices into plan.views, in their order) and sends each through its lenses and the sensor
/// into files; a view whose files are all there is written to the journal. While one view is rendered the
/// images of those before it are made; few are in memory at a time. The files are the same whatever the
/// threads. After a signal (interruption.h) or an error the view being rendered is given up, and those
/// already rendered are made. Throws the first error, in one line.
MakeViewsSummary make_views(const Plan& plan, const std::vector<std::int64_t>& views, Journal& journal,
                            const std::filesystem::path& root, int threads, Progress& progress);

}  // namespace cps
