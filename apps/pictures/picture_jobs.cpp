#include "apps/pictures/picture_jobs.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <string>

#include "apps/progress.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

/// Still pictures that OpenImageIO reads and writes.
constexpr std::array extensions{".png", ".jpg",  ".jpeg", ".exr", ".tif", ".tiff", ".hdr", ".bmp",
                                ".tga", ".webp", ".ppm",  ".pgm", ".pnm", ".pfm",  ".jp2", ".dpx"};

bool is_picture(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path relative = fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder));
  return !relative.empty() && *relative.begin() != "..";
}

}  // namespace

std::vector<PictureJob> picture_jobs(const fs::path& input, const fs::path& output) {
  if (!fs::exists(input)) throw std::runtime_error(input.string() + ": there is no such file or folder");
  if (!fs::is_directory(input)) {
    if (fs::weakly_canonical(input) == fs::weakly_canonical(output))
      throw std::runtime_error(output.string() + ": is the input; name another output");
    if (fs::is_directory(output)) return {{input, output / input.filename()}};
    return {{input, output}};
  }
  if (is_inside(output, input))
    throw std::runtime_error(output.string() + ": lies in the input folder; name another output");
  std::vector<PictureJob> jobs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(input))
    if (entry.is_regular_file() && is_picture(entry.path()))
      jobs.push_back({entry.path(), output / entry.path().lexically_relative(input)});
  if (jobs.empty()) throw std::runtime_error(input.string() + ": has no pictures in it");
  std::sort(jobs.begin(), jobs.end(),
            [](const PictureJob& a, const PictureJob& b) { return a.input < b.input; });
  return jobs;
}

int for_each_picture(const std::vector<PictureJob>& jobs,
                     const std::function<void(const PictureJob&)>& work) {
  Progress progress("pictures", 0, static_cast<std::int64_t>(jobs.size()));
  std::mutex progress_lock;
  std::vector<std::string> failures(jobs.size());
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    try {
      // Isolated, so that a thread that waits for the tiles of its picture does not begin another picture.
      tbb::this_task_arena::isolate([&] { work(jobs[i]); });
    } catch (const std::exception& error) {
      failures[i] = error.what();
    }
    const std::scoped_lock lock(progress_lock);
    progress.advance(1, jobs[i].input.filename().string());
  });
  int failed = 0;
  for (const std::string& failure : failures)
    if (!failure.empty()) {
      std::cerr << "cps: " << failure << "\n";
      ++failed;
    }
  if (jobs.size() > 1) progress.finish();
  return failed;
}

}  // namespace cps
