#include "apps/pictures/resampling.h"

#include <stdexcept>

#include "apps/threads.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
po::options_description describe(ResamplingRequest& request) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("input", po::value(&request.input)->required(), "a picture, or a folder of them (and below it)");
  add("output,o", po::value(&request.output)->required(), "a picture, or a folder");
  add("lens", po::value(&request.lens_file), "the calibration, in any format that cps lens check reads");
  add("camera", po::value(&request.lens_camera), "which of its cameras, by name");
  add("size", po::value(&request.size), "WIDTHxHEIGHT of the output");
  add("resampling", po::value(&request.resampling)->default_value(request.resampling),
      "footprint; nearest for ids; depth for z along the axis");
  add("encoding", po::value(&request.encoding)->default_value(request.encoding),
      "of the numbers: srgb is made linear light for the filter and encoded again; linear for data; auto: "
      "srgb for integers, linear for half and float");
  add("sigma", po::value(&request.sigma_px)->default_value(request.sigma_px),
      "standard deviation of the kernel, output pixels");
  add("label-format", po::value(&request.label_format)->default_value(request.label_format),
      "cps, opencv-yaml, opencv-xml, colmap, ros, kitti, kalibr, nerfstudio");
  add("label", po::value(&request.label_file), "the label's file [beside the pictures]");
  add_threads_option(options);
  return options;
}

void check(const ResamplingRequest& request) {
  resampling_of(request);
  try {
    encoding_from_string(request.encoding);
  } catch (const std::runtime_error& error) {
    throw po::error("--encoding " + request.encoding + ": " + error.what());
  }
  try {
    calibration_format_from_string(request.label_format);
  } catch (const std::runtime_error& error) {
    throw po::error(std::string("--label-") + error.what());
  }
  if (!(request.sigma_px >= 0.3 && request.sigma_px <= 4))
    throw po::error("--sigma: must lie between 0.3 and 4 pixels");
}

Resampling resampling_of(const ResamplingRequest& request) {
  if (request.resampling == "footprint") return Resampling::footprint;
  if (request.resampling == "nearest") return Resampling::nearest;
  if (request.resampling == "depth") return Resampling::depth;
  throw po::error("--resampling " + request.resampling + ": is none of footprint, nearest, depth");
}

Eigen::Vector2i first_size(const std::vector<PictureJob>& jobs) {
  for (std::size_t i = 0;; ++i) {
    try {
      const OIIO::ImageSpec spec = read_picture_header(jobs[i].input);
      return {spec.width, spec.height};
    } catch (const std::runtime_error&) {
      if (i + 1 == jobs.size()) throw;
    }
  }
}

fs::path label_path(const ResamplingRequest& request, const std::vector<PictureJob>& jobs) {
  if (!request.label_file.empty()) return request.label_file;
  const std::string name = usual_file_name(calibration_format_from_string(request.label_format));
  if (fs::is_directory(request.input)) return fs::path(request.output) / name;
  const fs::path& picture = jobs.front().output;
  return picture.parent_path() / (picture.stem().string() + "_" + name);
}

}  // namespace cps
