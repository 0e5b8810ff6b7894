#pragma once

#include <initializer_list>
#include <string>

#include "files/json_keys.h"

/// Guards against reading another lens model as Brown–Conrady. Calibrations of fisheye, omnidirectional and
/// rational lenses use the same key names as ours, plus one or two that tell them apart.
namespace cps {

/// Lower case, without separators: "Distortion_Model" and "distortion-model" are one key.
std::string plain_key(const std::string& key);

/// Whether `name` is a name that programs give to a pinhole with Brown–Conrady distortion, or with none
/// ("plumb_bob", "radtan", "OPENCV", …), whatever its case and separators.
bool names_brown_conrady(const std::string& name);

/// Throws std::runtime_error `<file>: <key>: …` if a key of the object names another lens model
/// (`fisheye_model: 1`, `camera_model: omni`) or holds a non-zero coefficient of one (`xi`, `k4`, `s1`).
/// `known`: the keys that the format's reader reads and checks itself.
void refuse_other_models(const JsonKeys& keys, std::initializer_list<const char*> known);

}  // namespace cps
