#pragma once

#include <string>

namespace c10 {
struct Device;
}

namespace cps {

/// What networks are computed on. Files hold what any device can go on with.
enum class Device { cpu, cuda };

/// "cpu" or "cuda". Throws std::runtime_error with one line on another word, and on "cuda" where LibTorch
/// sees no such device.
Device device_from_string(const std::string& word);

c10::Device to_torch(Device device);

}  // namespace cps
