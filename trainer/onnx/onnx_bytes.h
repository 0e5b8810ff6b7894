#pragma once

#include <string>

#include "trainer/onnx/onnx_model.h"

namespace cps {

/// The bytes of a .onnx file: IR version 8, operator set 17. The same model gives the same bytes.
std::string onnx_bytes(const OnnxModel& model);

}  // namespace cps
