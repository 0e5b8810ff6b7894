#include <nlohmann/json.hpp>

#include "files/files.h"
#include "tests/apps/cps_program.h"
#include "tests/dataset/labels/old_label.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

TEST_CASE("migrate says what it did, then that nothing is left to do") {
  const TemporaryFolder folder;
  const fs::path root = folder.path / "data";
  for (const char* part : {"train", "val", "test"})
    write_file(root / "splits" / (std::string(part) + ".txt"), {});
  const fs::path label = root / "480x270_hfov090/front_lens0026/calibration.json";
  write_file(label, old_label);
  const ProgramRun first = run_cps("migrate " + quoted(root));
  CHECK(first.exit_status == 0);
  CHECK(first.output == root.string() + ": migrated to schema 2; files rewritten: 1\n");
  CHECK(read_json(label)["gravity"] == nlohmann::json({0, 1, 0}));
  const ProgramRun second = run_cps("migrate " + quoted(root));
  CHECK(second.exit_status == 0);
  CHECK(second.output == root.string() + ": is at schema 2; nothing to do\n");
  check_refused("migrate " + quoted(folder.path / "none"), 1, "is not a folder");
  check_refused("migrate", 2, "dataset");
}
