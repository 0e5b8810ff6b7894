#include "apps/pictures/picture_jobs.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>

#include "apps/pictures/picture_format.h"
#include "apps/progress.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

/// The file or folder that `path` names, whether it exists or not.
fs::path identity(const fs::path& path) {
  return fs::weakly_canonical(fs::absolute(path));
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path relative = identity(path).lexically_relative(identity(folder));
  return !relative.empty() && *relative.begin() != "..";
}

void add_pictures(const fs::path& folder, const fs::path& below, std::set<fs::path>& visited,
                  std::vector<fs::path>& pictures, std::map<std::string, int>& read_only) {
  // A link may lead back to a folder above.
  if (!visited.insert(fs::canonical(folder)).second) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path name = below / entry.path().filename();
    if (entry.is_directory()) add_pictures(entry.path(), name, visited, pictures, read_only);
    if (!entry.is_regular_file()) continue;
    if (picture_format(entry.path()) != nullptr) pictures.push_back(name);
    if (is_read_only_picture(entry.path())) ++read_only[entry.path().extension().string()];
  }
}

}  // namespace

std::vector<PictureJob> picture_jobs(const fs::path& input, const fs::path& output) {
  if (!fs::exists(input)) throw std::runtime_error(input.string() + ": there is no such file or folder");
  if (!fs::is_directory(input)) {
    if (identity(input) == identity(output))
      throw std::runtime_error(output.string() + ": is the input; name another output");
    if (fs::is_directory(output)) return {{input, output / input.filename()}};
    return {{input, output}};
  }
  if (is_inside(output, input))
    throw std::runtime_error(output.string() + ": lies in the input folder; name another output");
  std::set<fs::path> visited;
  std::vector<fs::path> pictures;
  std::map<std::string, int> read_only;  // how many, by extension
  add_pictures(input, {}, visited, pictures, read_only);
  for (const auto& [extension, count] : read_only)
    std::cerr << "cps: " << input.string() << ": " << count << " " << extension
              << " left out: cps does not write that format; convert to .png or .exr\n";
  if (pictures.empty()) throw std::runtime_error(input.string() + ": has no pictures in it");
  std::ranges::sort(pictures);
  std::vector<PictureJob> jobs;
  for (const fs::path& picture : pictures) jobs.push_back({input / picture, output / picture});
  return jobs;
}

void refuse_replacing(const std::vector<fs::path>& inputs, const std::vector<fs::path>& outputs) {
  std::set<fs::path> read, written;
  for (const fs::path& input : inputs) read.insert(identity(input));
  for (const fs::path& output : outputs) {
    const fs::path path = identity(output);
    const auto is_same_file = [&](const fs::path& input) {
      std::error_code error;
      return fs::equivalent(input, path, error) && !error;
    };
    if (read.contains(path) || (fs::exists(path) && std::ranges::any_of(read, is_same_file)))
      throw std::runtime_error(output.string() + ": is an input and would be replaced: name another output");
    if (!written.insert(path).second)
      throw std::runtime_error(output.string() + ": would be written twice: name another output");
  }
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
