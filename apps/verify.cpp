#include "dataset/verify.h"

#include <iostream>

#include "apps/options.h"
#include "apps/verbs.h"

namespace po = boost::program_options;

namespace cps {

int cps_verify(const Arguments& arguments) {
  po::options_description options("Options");
  options.add_options()("dataset", po::value<std::string>()->required(), "the dataset's folder");
  po::positional_options_description positional;
  positional.add("dataset", 1);
  po::variables_map values;
  if (!parse_options(
          arguments,
          "cps verify DATASET\nChecks every file of a finished dataset against its labels, and every label "
          "against itself. Exit 1 when something is wrong.\n",
          options, positional, values))
    return 0;
  po::notify(values);
  const VerifySummary summary = verify_dataset(values["dataset"].as<std::string>());
  for (const std::string& fault : summary.faults) std::cerr << fault << "\n";
  std::cout << summary.brief() << "\n";
  return summary.faults.empty() ? 0 : 1;
}

}  // namespace cps
