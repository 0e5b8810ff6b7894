#include "dataset/migrate/migrate.h"

#include <fmt/format.h>

#include <iostream>

#include "apps/dataset/dataset_argument.h"
#include "apps/interruption.h"
#include "apps/verbs.h"
#include "dataset/labels/label.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

int migrate(const fs::path& root) {
  const Watch watch = interruptible_watch();
  const std::int64_t rewritten = migrate_dataset(root, [&](const std::string&) {
    if (watch.is_stopped()) throw Interrupted();
  });
  std::cout << root.string() << ": "
            << (rewritten == 0
                    ? fmt::format("is at schema {}; nothing to do\n", label_schema)
                    : fmt::format("migrated to schema {}; files rewritten: {}\n", label_schema, rewritten));
  return 0;
}

}  // namespace

const Manual migrate_manual{
    .name = "cps migrate",
    .summary = "add what labels have gained since a dataset was made",
    .synopsis = {"DATASET"},
    .description = R"(
Rewrites the labels of a finished dataset that an older version made, or of a set
of cps relens, as this version writes them (schema 2): adds gravity to every
calibration.json and frames.csv. Everything else in them stays as it is; images
and split lists are not touched. A dataset that is not migrated can be read all
the same.

Afterwards cps report asks for cps verify again, and an export of the dataset as
it was does not go on: export to a new folder.
)",
    .exit_status = {{"0", "migrated, or nothing to do"},
                    {"1", "failed"},
                    {"2", "wrong usage"},
                    {"75", "interrupted, or other processes still work there: run it again"}},
    .examples = {{"cps migrate data", "adds what the dataset in data/ lacks"}},
    .see_also = {"cps verify", "cps finish", "cps relens"},
};

int cps_migrate(const Arguments& arguments) {
  const std::optional<std::string> root = dataset_argument(arguments, migrate_manual);
  return root ? run_interruptible(*root, [&] { return migrate(*root); }) : 0;
}

}  // namespace cps
