#pragma once

#include <filesystem>

namespace cps {

/// Writes a copy of a model folder that is for handing on: model.json, which says that it is one, and
/// weights.pt with half_weights_of() the network. A Predictor of the copy computes in float32. A copy of a
/// copy has the same bytes. Each file appears by atomic rename, model.json last. Throws std::runtime_error
/// with one line if the folder holds no complete model, a weight is beyond float16, or `copy` holds a model
/// with float32 weights, which would be lost.
void write_half_model(const std::filesystem::path& model_folder, const std::filesystem::path& copy);

}  // namespace cps
