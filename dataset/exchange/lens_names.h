#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "files/json_keys.h"

/// Which lens model a calibration is of. Calibrations of all families use the same key names; one or two keys
/// tell them apart. A file whose keys contradict each other, or name a model that is none of ours, is
/// refused.
namespace cps {

/// A lens model as files name it. `plane`: brown_conrady or rational, which the coefficients tell apart.
enum class NamedLens { plane, kannala_brandt, unified_spherical, eucm, double_sphere };

/// Lower case, without separators: "Distortion_Model" and "distortion-model" are one key.
std::string plain_key(const std::string& key);

/// What programs mean by a lens model's name ("plumb_bob", "OPENCV_FISHEYE", "equidistant", "MEI", …),
/// whatever its case and separators. Empty for a name that says nothing of the lens ("pinhole", "none").
/// Throws std::runtime_error `<where>: is <name>, …` for models that are none of our families.
std::optional<NamedLens> lens_of_name(const std::string& name, const std::string& where);

/// The lens model that keys of the object name, by their value (`camera_model: omni`) or by themselves
/// (`fisheye_model: 1`); plane if none does. Throws std::runtime_error `<file>: <key>: …` for unknown models,
/// for one that is not `readable`, and when two keys name different ones.
NamedLens named_lens(const JsonKeys& keys, std::initializer_list<NamedLens> readable);

/// Throws std::runtime_error `<file>: <key>: …` if the object holds a coefficient (`xi`, `k4`, `s1`) that is
/// not 0 and not `known`, one of those that the format's reader reads and checks itself.
void refuse_other_coefficients(const JsonKeys& keys, std::initializer_list<const char*> known);

}  // namespace cps
