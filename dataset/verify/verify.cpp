#include "dataset/verify/verify.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "dataset/labels/label_check.h"
#include "dataset/labels/model_label_check.h"
#include "dataset/verify/dataset_files.h"
#include "dataset/verify/dense_check.h"
#include "dataset/verify/list_check.h"
#include "dataset/verify/pixel_check.h"
#include "dataset/verify/pose_check.h"

namespace cps {
namespace {

void check_labels(const Dataset& dataset, VerifySummary& summary) {
  std::vector<LabelCheck> checks(dataset.groups.size());
  tbb::parallel_for(std::size_t{0}, checks.size(), [&](std::size_t g) {
    const DatasetGroup& group = dataset.groups[g];
    checks[g] =
        group.model ? check_model_label(*group.model, dataset.root / group.folder) : check_label(group.label);
  });
  for (std::size_t g = 0; g < checks.size(); ++g) {
    for (const std::string& what : checks[g].faults)
      summary.faults.push_back((dataset.groups[g].folder / "calibration.json").string() + ": " + what);
    summary.max_roundtrip_px = std::max(summary.max_roundtrip_px, checks[g].max_roundtrip_px);
    summary.min_rim_margin_px = std::min(summary.min_rim_margin_px, checks[g].rim_margin_px);
  }
}

}  // namespace

std::string VerifySummary::brief() const {
  return fmt::format(
      "{} groups, {} images{}{}, {} faults; worst round trip {:.1e} px{}{}", groups, images,
      dense > 0 ? fmt::format(", {} dense labels", dense) : "",
      masters > 0 ? fmt::format(", {} masters", masters) : "", faults.size(), max_roundtrip_px,
      has_masters() ? fmt::format(", master's rim at least {:.1e} px outside", min_rim_margin_px) : "",
      has_record ? "" : "; no dataset.json and frames.csv: poses and hashes of files not checked");
}

VerifySummary verify_dataset(const std::filesystem::path& root) {
  VerifySummary summary;
  const DatasetFiles files = read_dataset_files(root, summary.faults, LensFamilies::any);
  summary.has_record = files.description.has_value();
  summary.groups = static_cast<std::int64_t>(files.dataset.groups.size());
  summary.images = static_cast<std::int64_t>(files.dataset.images.size());
  check_labels(files.dataset, summary);
  check_lists(files, summary.faults);
  check_images(files, summary.faults);
  summary.dense = check_dense(files, summary.faults);
  summary.masters = check_masters(files, summary.faults);
  check_streets(files, summary.faults);
  check_poses(files, summary.faults);
  return summary;
}

}  // namespace cps
