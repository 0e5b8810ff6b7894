#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "dataset/exchange/model_calibration.h"
#include "files/files.h"
#include "tests/temporary_folder.h"

namespace cps {

/// A file of this name and contents, in a folder that lives as long as the test program.
inline std::filesystem::path file_of(const std::string& name, const std::string& text) {
  static const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / name;
  std::filesystem::remove(file);
  write_file(file, text);
  return file;
}

/// What `action` throws: one line that begins with the file's name; "accepted" if it does not throw.
template <typename Action>
std::string refusal_of(const std::filesystem::path& file, const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    CHECK_THAT(error.what(), Catch::StartsWith(file.string() + ": "));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "accepted";
}

/// Why the file is refused, by those who read cameras of any family; "accepted" if it is not.
inline std::string refusal(const std::string& name, const std::string& text) {
  const std::filesystem::path file = file_of(name, text);
  return refusal_of(file, [&] {
    const ModelCalibrationFile read = read_model_calibration_file(file);
    if (!read.unread.empty()) throw std::runtime_error(read.unread[0].fault);
  });
}

/// The only camera of the file.
inline ModelCamera camera_of(const std::string& name, const std::string& text, ImageSize size = {0, 0}) {
  return read_model_camera(file_of(name, text), "", size);
}

/// The text with `old` replaced, which must be in it.
inline std::string with(std::string text, const std::string& old, const std::string& replacement) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), replacement);
}

}  // namespace cps
