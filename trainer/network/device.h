#pragma once

#include <string>

namespace c10 {
struct Device;
}

namespace cps {

/// Where networks are computed. Files hold CPU tensors, so any device can continue from them.
enum class Device { cpu, cuda };

/// Parses "cpu" or "cuda". Throws std::runtime_error with one line on any other word, and on "cuda" if
/// LibTorch finds no such device.
Device device_from_string(const std::string& word);

c10::Device to_torch(Device device);

}  // namespace cps
