#include "renderer/tiles.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>

#include "numbers/cpu_time.h"
#include "renderer/math/flush_denormals.h"

namespace cps {
namespace {

double thread_cpu_s() {
  return cpu_s(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace

double for_each_tile(int width, int height, const std::function<void(const Tile&)>& work,
                     const TileProgress& progress) {
  const int across = (width + Tile::side - 1) / Tile::side, down = (height + Tile::side - 1) / Tile::side;
  const int total = across * down;
  std::atomic<std::uint64_t> cpu_ns = 0;
  std::mutex reporting;
  int done = 0;
  tbb::parallel_for(
      tbb::blocked_range<int>(0, total),
      [&](const tbb::blocked_range<int>& tiles) {
        const FlushDenormals flush_denormals;
        const double cpu_begin = thread_cpu_s();
        for (int tile = tiles.begin(); tile != tiles.end(); ++tile)
          work({tile % across * Tile::side, tile / across * Tile::side});
        cpu_ns += static_cast<std::uint64_t>(1e9 * (thread_cpu_s() - cpu_begin));
        if (!progress) return;
        const std::lock_guard lock(reporting);
        done += static_cast<int>(tiles.size());
        progress(done, total);
      },
      tbb::simple_partitioner());
  return 1e-9 * static_cast<double>(cpu_ns.load());
}

}  // namespace cps
