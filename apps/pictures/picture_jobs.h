#pragma once

#include <filesystem>
#include <functional>
#include <vector>

/// Work on one picture or on a folder of pictures.
namespace cps {

struct PictureJob {
  std::filesystem::path input, output;
};

/// The picture `input`, written to `output`; or, if `input` is a folder, every picture in it and below it, in
/// the order of their names, to the same names under `output`. Pictures are recognised by their extension;
/// stderr names the kinds that cps cannot write. Links to folders are followed, each folder once.
/// Throws std::runtime_error in one line: nothing there, no pictures, output inside the input.
std::vector<PictureJob> picture_jobs(const std::filesystem::path& input, const std::filesystem::path& output);

/// Throws std::runtime_error naming the file if one of `outputs` is one of `inputs`, by whatever path, or is
/// there twice.
void refuse_replacing(const std::vector<std::filesystem::path>& inputs,
                      const std::vector<std::filesystem::path>& outputs);

/// Works on all pictures, several at a time, and shows a progress line if there are several. Prints the
/// message of each one that throws a std::exception on stderr, in the order of the names, and goes on with
/// the others. Returns the number of failures.
int for_each_picture(const std::vector<PictureJob>& jobs, const std::function<void(const PictureJob&)>& work);

}  // namespace cps
