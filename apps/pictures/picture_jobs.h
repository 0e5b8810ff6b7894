#pragma once

#include <filesystem>
#include <functional>
#include <vector>

/// One picture, or a folder of them, into another.
namespace cps {

struct PictureJob {
  std::filesystem::path input, output;
};

/// The picture `input`, written to `output`; or, if `input` is a folder, every picture in it and below it, in
/// the order of their names, to the same names under `output`. What is a picture is told by its extension.
/// Throws std::runtime_error in one line: nothing there, no pictures, output inside the input.
std::vector<PictureJob> picture_jobs(const std::filesystem::path& input, const std::filesystem::path& output);

/// Does the work on all of them, several at a time, with a line of progress when there are several. One that
/// fails (std::exception) is named on stderr, in the order of the names, and the others go on. Returns how
/// many failed.
int for_each_picture(const std::vector<PictureJob>& jobs, const std::function<void(const PictureJob&)>& work);

}  // namespace cps
