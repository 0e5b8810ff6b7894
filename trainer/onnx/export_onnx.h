#pragma once

#include <filesystem>
#include <string>

#include "trainer/model/train_options.h"

namespace cps {

/// The file in a model folder that `cps train` writes.
inline constexpr const char* onnx_file_name = "model.onnx";

/// Empty if networks with these options have an ONNX form; otherwise one line that names the option.
std::string onnx_fault(const TrainOptions& options);

/// Writes the trained network of a model folder as an ONNX file (docs/formats.md). It maps gray images to
/// labels; training's normalisation of both is part of it. By atomic rename. The same weights and model card
/// give the same bytes. Throws std::runtime_error with one line if the folder holds no complete model, or one
/// that onnx_fault() refuses, or the file cannot be written.
void write_onnx(const std::filesystem::path& model_folder, const std::filesystem::path& file);

}  // namespace cps
