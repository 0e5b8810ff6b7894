#include "trainer/model/make_network.h"

namespace cps {

NetworkOptions network_options(const TrainOptions& options) {
  return {.dropout = options.dropout,
          .size_features = options.size_features,
          .edge_channel = options.edge_channel,
          .orientation = options.orientation.measured,
          .edge_weights = is_fit(options.head),
          .outputs = unit_count(options.head)};
}

std::shared_ptr<Network> make_network(const TrainOptions& options) {
  return make_resnet(*find_architecture(options.architecture), network_options(options));
}

}  // namespace cps
