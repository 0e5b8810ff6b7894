#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/journal.h"
#include "dataset/job/ledger.h"
#include "production/frame_exposure.h"
#include "production/watch.h"
#include "renderer/cache/light_cache.h"
#include "sampler/plan/plan.h"

namespace cps {

/// What a run made, and a line about it for the user.
struct MakeViewsSummary : RunTimes {
  BadlyExposed badly_exposed;
  std::string brief() const;
};

/// How many views make_views() keeps in memory at a time. While one is rendered the images of the previous
/// ones are made, which is a small part of the work: few are enough.
int views_in_flight(int threads);

/// How many scenes make_views() keeps in memory at a time. With several threads, while one condition is
/// rendered, the scene of the next one loads on a thread more, so that none of them has to wait for it.
int scenes_in_memory(int threads);

/// Renders views (indices into plan.views, in their order) and photographs each through its lenses into
/// files. A view whose files are all written is entered in the journal. While one view is rendered the images
/// of the previous ones are made. The files are the same for any number of threads and memory of the cache.
/// Where the watch stops it, and after an error, the view being rendered is given up and those already
/// rendered are completed. Throws the first error, in one line.
MakeViewsSummary make_views(const Plan& plan, const std::vector<std::int64_t>& views, Journal& journal,
                            const std::filesystem::path& root, int threads, const Watch& watch,
                            const LightCacheOptions& cache = {});

}  // namespace cps
