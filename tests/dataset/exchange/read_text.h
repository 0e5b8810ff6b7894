#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "dataset/exchange/calibration_file.h"
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

/// Why the file is refused: one line that begins with its name; "accepted" if it is not.
inline std::string refusal(const std::string& name, const std::string& text) {
  const std::filesystem::path file = file_of(name, text);
  try {
    read_calibration(file);
  } catch (const std::runtime_error& error) {
    CHECK_THAT(error.what(), Catch::StartsWith(file.string() + ": "));
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "accepted";
}

}  // namespace cps
