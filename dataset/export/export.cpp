#include "dataset/export/export.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string_view>

#include "dataset/export/huggingface.h"
#include "dataset/export/targets.h"

namespace cps {
namespace {

struct Target {
  ExportTarget target;
  const char* name;
  void (*write)(const ExportJob& job);
  bool needs_poses = false;
  bool needs_instances = false;  ///< dense labels `instance` and `semantic`
};
constexpr std::array targets = {
    Target{ExportTarget::webdataset, "webdataset", export_webdataset},
    Target{ExportTarget::huggingface, "huggingface", export_huggingface},
    Target{ExportTarget::colmap, "colmap", export_colmap, true},
    Target{ExportTarget::nerfstudio, "nerfstudio", export_nerfstudio, true},
    Target{ExportTarget::kitti, "kitti", export_kitti},
    Target{ExportTarget::coco, "coco", export_coco, false, true},
};

const Target& row_of(ExportTarget target) {
  return *std::ranges::find(targets, target, &Target::target);
}

/// Throws std::runtime_error with one line when the dataset lacks what the target is made of.
void require_contents(const ExportSource& source, const Target& target) {
  const std::string root = source.dataset().root.string();
  if (target.needs_poses && !source.has_frames())
    throw std::runtime_error(root + ": has no frames.csv, so no poses, which --to " + target.name +
                             " needs: choose another target");
  for (DenseLabel label : {DenseLabel::instance, DenseLabel::semantic})
    if (target.needs_instances && !source.has(label))
      throw std::runtime_error(root + ": has no dense label " + to_string(label) + ", which --to " +
                               target.name +
                               " needs: make it with labels = instance, semantic in its recipe");
}

bool is_identifier(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view(".+-").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

bool is_date(std::string_view text) {
  constexpr std::string_view form = "0000-00-00";
  return std::ranges::equal(text, form, [](unsigned char c, char f) {
    return f == '0' ? std::isdigit(c) != 0 : c == static_cast<unsigned char>(f);
  });
}

bool has_control_characters(std::string_view text) {
  return std::ranges::any_of(text, [](unsigned char c) { return std::iscntrl(c) != 0; });
}

}  // namespace

std::string to_string(ExportTarget target) {
  return row_of(target).name;
}

ExportTarget export_target_from_string(const std::string& name) {
  std::string known;
  for (const Target& target : targets) {
    if (name == target.name) return target.target;
    known += std::string(known.empty() ? "" : ", ") + target.name;
  }
  throw std::runtime_error("is none of " + known);
}

std::array<std::pair<const char*, const std::string*>, 4> ExportOptions::publication() const {
  return {{{"license", &license}, {"url", &url}, {"creator", &creator}, {"published", &published}}};
}

std::string ExportOptions::fault() const {
  if (shard_mb < 1 || shard_mb > 1'000'000) return "shard_mb: must lie in [1, 1000000]";
  for (const auto& [name, value] : publication()) {
    if (!value->empty() && target != ExportTarget::huggingface)
      return std::string(name) + ": is for --to huggingface only: leave it out";
    if (has_control_characters(*value)) return std::string(name) + ": must not have line breaks";
  }
  if (!is_identifier(license)) return "license: must be an identifier such as cc-by-4.0";
  if (!published.empty() && !is_date(published)) return "published: must be a date, YYYY-MM-DD";
  return "";
}

ExportSummary export_dataset(const ExportSource& source, const std::filesystem::path& out,
                             const ExportOptions& options, const ExportProgress& progress) {
  const Target& target = row_of(options.target);
  require_contents(source, target);
  ExportFolder folder(out, source, options);
  ExportSummary summary{.was_finished = folder.is_finished()};
  if (!summary.was_finished) {
    target.write({source, options, folder, progress});
    folder.finish();
  }
  if (const std::string missing = missing_in_croissant(options);
      options.target == ExportTarget::huggingface && !missing.empty())
    summary.note = "croissant.json lacks what Croissant 1.1 requires and only you know: " + missing;
  return summary;
}

}  // namespace cps
