#pragma once

#include <string>

namespace cps {

/// The number format in which a network's convolutions are computed while it is trained. Weights, losses and
/// the optimiser are always in float32.
enum class Precision {
  automatic,  ///< bfloat16 where the processor computes it, else float32
  float32,
  bfloat16  ///< float32's range with 8 significant bits; other processors emulate it, slowly
};

/// "auto", "float32" or "bfloat16".
std::string to_string(Precision precision);
/// Throws std::runtime_error on any other word.
Precision precision_from_string(const std::string& word);

/// Whether this processor has instructions for bfloat16: AVX512_BF16 or AMX-BF16.
bool processor_computes_bfloat16();

/// `asked`, or for `automatic` the format that follows from whether bfloat16 is computed where the network is
/// trained.
Precision chosen_precision(Precision asked, bool computes_bfloat16);

/// One line on float32 or bfloat16 for the summary of a training on this machine.
std::string precision_report(Precision used, bool computes_bfloat16);

}  // namespace cps
