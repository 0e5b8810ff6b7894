#include "trainer/images/places.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "random/counter_hash.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// The things of the chosen places. `place_name` gives a thing's place.
template <typename Thing, typename PlaceName>
std::vector<Thing> of_chosen_places(const std::vector<Thing>& things, double share, PlaceName place_name) {
  if (share >= 1) return things;
  const Stream stream = make_stream(0, "share of places");
  const auto ranked = [&](const Thing& thing) {
    const std::string place = place_name(thing);
    return std::pair{make_stream(stream.key, place).key, place};
  };
  std::set<std::pair<std::uint64_t, std::string>> places;
  for (const Thing& thing : things) places.insert(ranked(thing));
  const long kept = std::max(1l, std::lround(share * static_cast<double>(places.size())));
  if (kept >= static_cast<long>(places.size())) return things;
  const auto first_left_out = std::next(places.begin(), kept);
  std::vector<Thing> chosen;
  for (const Thing& thing : things)
    if (ranked(thing) < *first_left_out) chosen.push_back(thing);
  return chosen;
}

}  // namespace

std::string place_of(const Dataset& dataset, const DatasetImage& image) {
  const DatasetGroup& group = dataset.groups[image.group];
  const fs::path set = group.folder.parent_path();
  if (set.string().ends_with("_panoramas")) return (set / group.label.rig_camera).string();
  return (set / image.file.stem()).string();
}

std::string place_of(const KeptMaster& master) {
  const std::string name = master.file.stem().string();  // <camera>_<place>
  return (master.file.parent_path().filename() / name.substr(name.rfind('_') + 1)).string();
}

std::vector<int> share_of_places(const Dataset& dataset, const std::vector<int>& images, double share) {
  return of_chosen_places(images, share, [&](int i) { return place_of(dataset, dataset.images[i]); });
}

std::vector<KeptMaster> share_of_places(const std::vector<KeptMaster>& masters, double share) {
  return of_chosen_places(masters, share, [](const KeptMaster& master) { return place_of(master); });
}

}  // namespace cps
