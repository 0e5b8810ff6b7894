#include "dataset/job/write_label.h"

#include "dataset/labels/group_label.h"
#include "dataset/labels/valid_mask.h"
#include "files/files.h"
#include "files/png.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// Whether the leaf folder has a label in the form that is written today, and the mask that it names.
bool has_label(const fs::path& leaf) {
  const fs::path file = leaf / "calibration.json";
  if (!fs::exists(file)) return false;
  const nlohmann::json json = read_json(file);
  if (schema_of({json, file.string()}) != label_schema) return false;
  return !json.contains("valid") || fs::exists(leaf / valid_mask_file);
}

}  // namespace

void write_label(const fs::path& root, const Plan& plan, const PlannedGroup& group) {
  const fs::path leaf = root / group.folder, file = leaf / "calibration.json";
  if (has_label(leaf)) return;
  if (!group.model) return write_json(file, to_json(group_label(plan, group)));
  const std::optional<OIIO::ImageBuf> mask = valid_mask(*group.model);
  if (mask) write_file(leaf / valid_mask_file, encode_png(*mask));  // before the label, which names it
  write_json(file, to_json(group_model_label(plan, group, mask.has_value())));
}

}  // namespace cps
