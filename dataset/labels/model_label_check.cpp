#include "dataset/labels/model_label_check.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "dataset/labels/valid_mask.h"
#include "files/files.h"
#include "files/png.h"

namespace cps {
namespace {

/// Between numbers that are computed again in the same way.
constexpr double same_number = 1e-8;

bool is_same_angle(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= same_number);
}

/// Empty when the mask is as the label says: the lens' own, or none.
std::string mask_fault(const ModelLabel& label, const std::filesystem::path& file) try {
  if (label.valid.empty())
    return std::filesystem::exists(file) ? "valid: is missing, but there is a mask" : "";
  const std::optional<OIIO::ImageBuf> mask = valid_mask(label.camera);
  if (!mask) return "valid: names a mask, but every pixel is valid";
  return read_file(file) == encode_png(*mask) ? ""
                                              : "valid: " + label.valid + " is not the mask of this lens";
} catch (const std::runtime_error& error) {
  return error.what();
}

/// Notes where the label differs from what was found for its camera.
void compare_labels(const ModelLabel& label, const ModelLabel& found, LabelCheck& check) {
  const auto fault = [&](bool is_fault, const std::string& what) {
    if (is_fault) check.faults.push_back(what);
  };
  fault(std::abs(found.certificate_min_scale - label.certificate_min_scale) > same_number,
        fmt::format("certificate: min_scale {} is claimed, {} found", label.certificate_min_scale,
                    found.certificate_min_scale));
  check.max_roundtrip_px = found.certificate_max_roundtrip_px;
  fault(!(check.max_roundtrip_px <= 1e-6),
        fmt::format("certificate: round trip off by {} px", check.max_roundtrip_px));
  fault(!(is_same_angle(found.seen.horizontal_rad, label.seen.horizontal_rad) &&
          is_same_angle(found.seen.vertical_rad, label.seen.vertical_rad) &&
          is_same_angle(found.seen.diagonal_rad, label.seen.diagonal_rad)),
        "fov_true_deg: contradicts model, params and K");
  fault(!label.valid.empty() && std::abs(found.max_angle_rad - label.max_angle_rad) > same_number,
        "certificate: max_angle_deg contradicts model, params and K");
}

}  // namespace

LabelCheck check_model_label(const ModelLabel& label, const std::filesystem::path& leaf) {
  LabelCheck check;
  check.rim_margin_px = std::numeric_limits<double>::infinity();
  try {
    compare_labels(label, label.valid.empty() ? model_label(label.camera) : masked_model_label(label.camera),
                   check);
  } catch (const std::runtime_error& error) {
    check.faults.emplace_back(error.what());
    return check;
  }
  if (const std::string fault = mask_fault(label, leaf / valid_mask_file); !fault.empty())
    check.faults.push_back(fault);
  return check;
}

}  // namespace cps
