#include <filesystem>
#include <iostream>

#include "apps/options.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "dataset/files.h"
#include "trainer/evaluate.h"
#include "trainer/threads.h"

namespace po = boost::program_options;

namespace cps {

int eval_verb(const Arguments& arguments) {
  std::string model, data, part, out;
  po::options_description options("Options");
  options.add_options()("model", po::value<std::string>(&model)->required(), "the model's folder")(
      "data", po::value<std::string>(&data)->required(), "the dataset's folder")(
      "part", po::value<std::string>(&part)->default_value("test"), "train, val or test")(
      "out", po::value<std::string>(&out), "the table as JSON [MODEL/eval.json]");
  po::variables_map values;
  if (!parse_options(
          arguments,
          "cps eval --model MODEL --data DATASET\nErrors of a trained network on a part of a dataset, beside "
          "those of two predictors that look at nothing.\n",
          options, {}, values))
    return 0;
  po::notify(values);
  use_threads(0);

  const Part measured = usage_checked([&] { return part_from_string(part); });
  if (measured == Part::all) throw po::error("--part: say train, val or test");
  Evaluation evaluation = evaluate(Predictor(model), read_dataset(data), measured);
  evaluation.model = model;
  const std::filesystem::path file =
      out.empty() ? std::filesystem::path(model) / "eval.json" : std::filesystem::path(out);
  write_json(file, to_json(evaluation));
  std::cout << evaluation.report() << "written to " << file.string() << "\n";
  return 0;
}

}  // namespace cps
