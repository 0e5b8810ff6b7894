#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "files/plot.h"
#include "numbers/interval.h"
#include "sampler/part.h"

namespace cps {

/// The values of one number over the images of a dataset.
struct Distribution {
  std::string name, unit;
  std::optional<Interval> limits = {};             ///< that the values must keep
  std::string note = {};                           ///< what limits them
  std::array<std::vector<double>, 3> values = {};  ///< of train, val and test

  void add(Part part, double value) { values[static_cast<std::size_t>(part)].push_back(value); }
};

struct DistributionSummary {
  std::int64_t count = 0;
  double min = 0, mean = 0, max = 0, standard_deviation = 0;
  std::int64_t outside = 0;  ///< values beyond the limits by more than rounding
};

DistributionSummary summary_of(const Distribution& distribution);

/// Histograms of the three parts on common bins, in percent of the part's images, beside the limits. Needs at
/// least one value.
Plot distribution_plot(const Distribution& distribution);

/// The plot with the summary below it, as HTML; nothing without values. `number` tells the diagrams of one
/// page apart.
std::string to_html(const Distribution& distribution, std::size_t number);

}  // namespace cps
