#include "trainer/network/precision.h"

#include <cpuid.h>

#include <stdexcept>

namespace cps {

std::string to_string(Precision precision) {
  return precision == Precision::automatic ? "auto"
         : precision == Precision::float32 ? "float32"
                                           : "bfloat16";
}

Precision precision_from_string(const std::string& word) {
  for (Precision precision : {Precision::automatic, Precision::float32, Precision::bfloat16})
    if (word == to_string(precision)) return precision;
  throw std::runtime_error("precision '" + word + "': unknown: use auto, float32 or bfloat16");
}

bool processor_computes_bfloat16() {
  if (__builtin_cpu_supports("avx512bf16")) return true;
  // Clang 14 does not know the name of the other.
  constexpr unsigned amx_bf16 = 1u << 22;
  unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
  return __get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) && (edx & amx_bf16);
}

Precision chosen_precision(Precision asked, bool computes_bfloat16) {
  if (asked != Precision::automatic) return asked;
  return computes_bfloat16 ? Precision::bfloat16 : Precision::float32;
}

std::string precision_report(Precision used, bool computes_bfloat16) {
  const std::string precision = "precision " + to_string(used);
  if (used == Precision::bfloat16)
    return precision + (computes_bfloat16 ? ", which this processor computes"
                                          : ", which this processor only emulates: slower than float32");
  return precision + (computes_bfloat16 ? "; this processor also computes bfloat16"
                                        : "; this processor does not compute bfloat16");
}

}  // namespace cps
