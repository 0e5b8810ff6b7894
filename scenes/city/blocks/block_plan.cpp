#include "scenes/city/blocks/block_plan.h"

#include <algorithm>

#include "scenes/city/blocks/block_kinds.h"

namespace cps::city {
namespace {

BlockKind draw_kind(const CityCharacter& c, bool at_rim, Draws& draws) {
  const double park = at_rim ? 0 : c.park;
  double x = draws.uniform(0, c.closed + c.detached + c.slabs + c.towers + c.halls + park);
  if ((x -= c.closed) < 0) return BlockKind::closed;
  if ((x -= c.detached) < 0) return BlockKind::detached;
  if ((x -= c.slabs) < 0) return BlockKind::slabs;
  if ((x -= c.towers) < 0) return BlockKind::towers;
  if ((x -= c.halls) < 0) return BlockKind::halls;
  return BlockKind::park;
}

}  // namespace

Vec2 block_middle(const StreetNetwork& network, int block) {
  Vec2 sum(0, 0);
  for (const Side& side : network.blocks[block].sides) sum += network.junctions[network.start(side)].position;
  return sum / static_cast<double>(network.blocks[block].sides.size());
}

BlockPlan plan_block(const StreetNetwork& network, int index, const CityCharacter& character,
                     std::uint64_t seed) {
  const Block& block = network.blocks[index];
  Draws draws{substream(make_stream(seed, "block"), index)};
  BlockPlan plan;
  plan.kind = draw_kind(character, block.at_rim, draws);
  double widest = 0;
  for (const Side& side : block.sides) {
    plan.pavement_m.push_back(network.is_road(side) ? network.profile(side).pavement_m : 0);
    widest = std::max(widest, plan.pavement_m.back());
  }
  plan.border = outline(network, block, plan.pavement_m, widest);
  BlockSite site{plan, character, draws, without_repeats(plan.border.points),
                 frontages(network, block, plan.border)};
  switch (plan.kind) {
    case BlockKind::closed:
      fill_closed_block(site);
      break;
    case BlockKind::detached:
      fill_detached_block(site);
      break;
    case BlockKind::slabs:
      fill_slab_block(site);
      break;
    case BlockKind::towers:
      fill_tower_block(site);
      break;
    case BlockKind::halls:
      fill_hall_block(site);
      break;
    case BlockKind::park:
      plant(site, 8, 2.5);
      break;
  }
  return plan;
}

}  // namespace cps::city
