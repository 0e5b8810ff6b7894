#include "dataset/verify/kept_results.h"

#include <algorithm>
#include <cmath>

#include "dataset/labels/group_label.h"
#include "files/files.h"
#include "files/json_keys.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_kept_faults = 100;

fs::path verification_file(const fs::path& root) {
  return root / ".cps" / "verify.json";
}
fs::path rerender_file(const fs::path& root) {
  return root / ".cps" / "rerender.json";
}

/// JSON has no infinity: it is written as null.
double number_or_infinity(const JsonKeys& keys, const char* key) {
  return keys.at(key).is_null() ? INFINITY : keys.number(key);
}

std::int64_t count(const JsonKeys& keys, const char* key) {
  return static_cast<std::int64_t>(keys.unsigned_integer(key));
}

const nlohmann::json& list(const JsonKeys& keys, const char* key) {
  if (!keys.at(key).is_array()) keys.fail(key, "must be a list");
  return keys.at(key);
}

RerenderedImage rerendered_image(const JsonKeys& keys) {
  const std::vector<double> shift = keys.numbers("shift_px", 2);
  return {.file = keys.text("file"),
          .registration = {.shift_x_px = shift[0],
                           .shift_y_px = shift[1],
                           .shift_noise_px = number_or_infinity(keys, "shift_noise_px"),
                           .blocks = static_cast<int>(count(keys, "blocks")),
                           .block_rms_px = number_or_infinity(keys, "block_rms_px"),
                           .worst_block_px = number_or_infinity(keys, "worst_block_px"),
                           .correlation = number_or_infinity(keys, "correlation"),
                           .psnr_db = number_or_infinity(keys, "psnr_db")},
          .fault = keys.text("fault")};
}

}  // namespace

std::string description_sha256(const fs::path& root) {
  const fs::path file = root / "dataset.json";
  return fs::exists(file) ? sha256(read_file(file)) : "";
}

void keep_verification(const fs::path& root, const VerifySummary& summary, bool is_planned_again) {
  const auto kept = std::min(summary.faults.size(), max_kept_faults);
  write_json(verification_file(root),
             {{"generator", generator_name()},
              {"dataset_sha256", description_sha256(root)},
              {"groups", summary.groups},
              {"images", summary.images},
              {"masters", summary.masters},
              {"max_roundtrip_px", summary.max_roundtrip_px},
              {"min_rim_margin_px", summary.min_rim_margin_px},
              {"planned_again", is_planned_again},
              {"faults", summary.faults.size()},
              {"first_faults",
               std::vector<std::string>(summary.faults.begin(),
                                        summary.faults.begin() + static_cast<std::ptrdiff_t>(kept))}});
}

void keep_rerender(const fs::path& root, const KeptRerender& rerender) {
  nlohmann::ordered_json images = nlohmann::json::array();
  for (const RerenderedImage& image : rerender.images) {
    const Registration& found = image.registration;
    images.push_back({{"file", image.file},
                      {"shift_px", {found.shift_x_px, found.shift_y_px}},
                      {"shift_noise_px", found.shift_noise_px},
                      {"blocks", found.blocks},
                      {"block_rms_px", found.block_rms_px},
                      {"worst_block_px", found.worst_block_px},
                      {"correlation", found.correlation},
                      {"psnr_db", found.psnr_db},
                      {"fault", image.fault}});
  }
  write_json(rerender_file(root), {{"samples", rerender.samples},
                                   {"most_shift_px", rerender.max_shift_px},
                                   {"most_block_rms_px", rerender.max_block_rms_px},
                                   {"images", images}});
}

std::optional<KeptVerification> kept_verification(const fs::path& root) {
  const std::string file = verification_file(root).string();
  if (!fs::exists(file)) return std::nullopt;
  const nlohmann::json json = read_json(file);
  const JsonKeys keys{json, file};
  KeptVerification kept{.generator = keys.text("generator"),
                        .dataset_sha256 = keys.text("dataset_sha256"),
                        .groups = count(keys, "groups"),
                        .images = count(keys, "images"),
                        .masters = count(keys, "masters"),
                        .max_roundtrip_px = number_or_infinity(keys, "max_roundtrip_px"),
                        .min_rim_margin_px = number_or_infinity(keys, "min_rim_margin_px"),
                        .is_planned_again = keys.at("planned_again") == true,
                        .faults = count(keys, "faults"),
                        .first_faults = {}};
  for (const nlohmann::json& fault : list(keys, "first_faults")) {
    if (!fault.is_string()) keys.fail("first_faults", "must be a list of texts");
    kept.first_faults.push_back(fault.get<std::string>());
  }
  return kept;
}

std::optional<KeptRerender> kept_rerender(const fs::path& root) {
  const std::string file = rerender_file(root).string();
  if (!fs::exists(file)) return std::nullopt;
  const nlohmann::json json = read_json(file);
  const JsonKeys keys{json, file};
  KeptRerender kept{.samples = static_cast<int>(count(keys, "samples")),
                    .max_shift_px = keys.number("most_shift_px"),
                    .max_block_rms_px = keys.number("most_block_rms_px"),
                    .images = {}};
  for (const nlohmann::json& image : list(keys, "images"))
    kept.images.push_back(rerendered_image({image, file}));
  return kept;
}

}  // namespace cps
