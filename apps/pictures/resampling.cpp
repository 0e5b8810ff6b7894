#include "apps/pictures/resampling.h"

#include <fmt/format.h>

#include <atomic>
#include <stdexcept>

#include "apps/threads.h"
#include "distortion/models/warp/seen_hfov.h"
#include "distortion/models/warp/warp_models.h"
#include "files/files.h"
#include "files/png.h"
#include "numbers/angles.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
po::options_description describe(ResamplingRequest& request) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("input", po::value(&request.input)->value_name("PATH")->required(),
      "a picture, or a folder: all pictures in it and below it; its name alone will do, without --input");
  add("out,o", po::value(&request.output)->value_name("PATH")->required(),
      "the picture to write, or the folder for all of them");
  add("lens", po::value(&request.lens_file)->value_name("FILE"),
      "file with the calibration of the lens, in any format that cps lens check reads");
  add("lens-camera", po::value(&request.lens_camera)->value_name("NAME"),
      "name of the camera in the --lens file, if it holds several");
  add("size", po::value(&request.size)->value_name("WxH"),
      "size of the output, WIDTHxHEIGHT in pixels [the calibration's]");
  add("resampling", po::value(&request.resampling)->value_name("WORD")->default_value(request.resampling),
      "footprint, a filter over each output pixel's footprint; nearest, for label ids; depth, for distances "
      "along the optical axis");
  add("encoding", po::value(&request.encoding)->value_name("WORD")->default_value(request.encoding),
      "what the pixel values are: srgb, which is decoded before filtering and encoded after it; linear, for "
      "light and data; auto, srgb for integers and linear for half and float");
  add("sigma", po::value(&request.sigma_px)->default_value(request.sigma_px),
      "standard deviation of the filter, output pixels, 0.3 to 4");
  add("label-format",
      po::value(&request.label_format)->value_name("FORMAT")->default_value(request.label_format),
      "format of the label: cps, opencv-yaml, opencv-xml, colmap, ros, kitti, kalibr, nerfstudio");
  add("label", po::value(&request.label_file)->value_name("FILE"),
      "file to write the label to [beside the pictures]");
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

ImageSize first_size(const std::vector<PictureJob>& jobs) {
  for (std::size_t i = 0;; ++i) {
    try {
      return upright_size(jobs[i].input);
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

WarpOptions warp_options(const ResamplingRequest& request) {
  return {.oversampling = 1,
          .kernel_sigma_px = request.sigma_px,
          .resampling = resampling_of(request),
          .require_resolution = false};
}

namespace {

/// Throws before any work if an output, the label among them, would replace what is read.
void refuse_replacing_inputs(const ResamplingRequest& request, const std::vector<PictureJob>& jobs,
                             const fs::path& label) {
  std::vector<fs::path> inputs, outputs{label};
  if (!request.valid_file.empty()) outputs.emplace_back(request.valid_file);
  for (const std::string& file : {request.lens_file, request.source_file})
    if (!file.empty()) inputs.emplace_back(file);
  for (const PictureJob& job : jobs) {
    inputs.push_back(job.input);
    outputs.push_back(job.output);
  }
  refuse_replacing(inputs, outputs);
}

/// Throws before any work if the label's format has no place for a family. (What it lacks for Brown–Conrady
/// lenses, write_model_calibration() says.)
void refuse_other_format(const ResamplingRequest& request, const LensModel& lens) {
  if (std::holds_alternative<Distortion>(lens)) return;
  if (!can_hold(calibration_format_from_string(request.label_format), lens))
    throw std::runtime_error(
        fmt::format("--label-format {}: cannot hold a {} lens: choose another, such as cps",
                    request.label_format, family_name(lens)));
}

/// The label's H-FOV in words: 2·atan(W / 2fx) of a Brown–Conrady camera, of the others what they show.
std::string hfov_text(const ModelCamera& camera) {
  std::optional<double> angle_rad = hfov_rad(camera.pinhole);
  if (!std::holds_alternative<Distortion>(camera.lens))
    angle_rad = seen_hfov_rad(camera, certify_frame(camera, warpable).region);
  return angle_rad ? fmt::format("H-FOV {:.2f} degrees", degrees(*angle_rad)) : "H-FOV not proved";
}

}  // namespace

int resample_pictures(const ResamplingRequest& request, const std::vector<PictureJob>& jobs,
                      const ModelCamera& source, const ModelCamera& output, const std::string& remark,
                      const std::function<OIIO::ImageBuf(const OIIO::ImageBuf&)>& resample) {
  refuse_other_format(request, output.lens);
  const Encoding encoding = encoding_from_string(request.encoding);
  const Resampling resampling = resampling_of(request);
  const fs::path label = label_path(request, jobs);
  refuse_replacing_inputs(request, jobs, label);
  // An older label must not stand beside new pictures, nor the new one beside older pictures.
  fs::remove(label);
  std::atomic<int> turned = 0, older = 0;
  const int failed = for_each_picture(jobs, [&](const PictureJob& job) {
    try {
      const Picture picture =
          read_picture(job.input, encoding, resampling, source.pinhole.width, source.pinhole.height);
      write_picture(job.output, resample(picture.pixels), picture);
      turned += picture.was_turned ? 1 : 0;
    } catch (...) {
      older += fs::exists(job.output) ? 1 : 0;
      throw;
    }
  });
  if (turned > 0)
    fmt::print(stderr, "cps: {} pictures were turned upright, as their EXIF orientation says\n",
               turned.load());
  const auto made = static_cast<int>(jobs.size()) - failed;
  if (older > 0)
    throw std::runtime_error(fmt::format(
        "{}: not written: {} of the pictures are of an earlier run, because they failed in this one: remove them "
        "and run again",
        label.string(), older.load()));
  if (made == 0) return 1;
  write_model_calibration(label, calibration_format_from_string(request.label_format), std::vector{output});
  if (!request.valid_file.empty())
    write_file(request.valid_file, encode_png(valid_pixels(source, output, warp_options(request))));
  fmt::print("{}: {} x {}, {}{}; {} pictures, {} failed\n", label.string(), output.pinhole.width,
             output.pinhole.height, hfov_text(output), remark, made, failed);
  return failed > 0 ? 1 : 0;
}

}  // namespace cps
