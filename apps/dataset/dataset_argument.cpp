#include "apps/dataset/dataset_argument.h"

#include "apps/options.h"

namespace po = boost::program_options;

namespace cps {

std::optional<std::string> dataset_argument(const Arguments& arguments, const Manual& manual) {
  po::options_description options("Options");
  options.add_options()("dataset", po::value<std::string>()->value_name("DATASET")->required(),
                        "the dataset's folder");
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(arguments, manual, options, positional, values)) return {};
  po::notify(values);
  return values["dataset"].as<std::string>();
}

}  // namespace cps
