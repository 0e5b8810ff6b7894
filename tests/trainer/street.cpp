#include "tests/trainer/street.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/inverse/inverse.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"

namespace cps {
namespace {

const CertificateOptions comfortably_one_to_one{1e-3, 100};

double hash01(std::uint64_t seed, int a, int b, int c) {
  return random_uniform(substream(substream(make_stream(seed, "street"), a + 1000), b + 1000), c + 1000);
}

/// Brightness 0…1 along a ray from a camera 1.65 m above the middle of a lane; x right, y down, z forward.
double street_brightness(const Eigen::Vector3d& ray, std::uint64_t place) {
  const double half_width = 7 + 6 * hash01(place, 0, 0, 0), camera_height = 1.65;
  const double lane_offset = -2 + 4 * hash01(place, 0, 0, 1);
  double nearest = 400, brightness = .75 + .2 * std::max(0.0, -ray.y() / ray.norm());  // sky
  if (ray.y() > 1e-6 && camera_height / ray.y() < nearest) {
    nearest = camera_height / ray.y();
    const double x = nearest * ray.x() + lane_offset, z = nearest * ray.z();
    brightness = .28 + .06 * hash01(place, 1, std::floor(x / .7), std::floor(z / .7));
    if (std::abs(std::abs(x) - 3.5) < .1) brightness = .85;
    if (std::abs(x) < .08 && std::fmod(std::abs(z), 9) < 4) brightness = .85;
    if (std::abs(x) > half_width - 2.5) brightness += .15 + .08 * (static_cast<int>(std::floor(z / 1.5)) & 1);
  }
  for (int side : {-1, 1}) {
    const double distance = (side * half_width - lane_offset) / ray.x();
    if (!(distance > 0 && distance < nearest)) continue;
    const double z = distance * ray.z(), height = camera_height - distance * ray.y();
    const int house = static_cast<int>(std::floor(z / 14));
    const double tall = 5 + 14 * hash01(place, 2 + side, house, 0);
    if (height < 0 || height > tall) continue;
    nearest = distance;
    const double bay = 1.6 + 1.6 * hash01(place, 2 + side, house, 1),
                 storey = 2.8 + .8 * hash01(place, 2 + side, house, 2);
    brightness = .35 + .5 * hash01(place, 2 + side, house, 3);
    const double u = z / bay - std::floor(z / bay), v = height / storey - std::floor(height / storey);
    if (u > .3 && u < .75 && v > .3 && v < .8) brightness *= .45;
  }
  return brightness;
}

}  // namespace

void write_png(const GrayImage& image, const std::filesystem::path& file) {
  auto out = OIIO::ImageOutput::create(file.string());
  const OIIO::ImageSpec spec(image.size.width, image.size.height, 1, OIIO::TypeDesc::UINT8);
  if (!out || !out->open(file.string(), spec) ||
      !out->write_image(OIIO::TypeDesc::UINT8, image.pixels.data()))
    throw std::runtime_error(file.string() + ": not written");
  out->close();
}

GrayImage render_street(const ImageSize& size,
                        const std::function<Eigen::Vector3d(const Eigen::Vector2d& pixel)>& ray_at,
                        std::uint64_t place) {
  const double yaw = .12 * (hash01(place, 5, 0, 0) - .5), pitch = .08 * (hash01(place, 5, 0, 1) - .5);
  const Eigen::Matrix3d heading =
      (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  const Stream noise = make_stream(place, "noise");
  GrayImage image{size, {}};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      double sum = 0;
      for (int s = 0; s < 4; ++s) {
        const Eigen::Vector2d pixel(x - .25 + .5 * (s & 1), y - .25 + .5 * (s >> 1));
        sum += street_brightness(heading * ray_at(pixel), place);
      }
      const double noisy = 255 * sum / 4 + 3 * random_normal(noise, image.pixels.size());
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(noisy, 0.0, 255.0))));
    }
  return image;
}

GrayImage render_street(const CalibratedCamera& calibration, std::uint64_t place) {
  const Pinhole& camera = calibration.pinhole;
  const FrameCertificate frame = certify_frame(calibration.distortion, camera, comfortably_one_to_one);
  const auto ray_at = [&](const Eigen::Vector2d& pixel) -> Eigen::Vector3d {
    return undistort(calibration.distortion, frame.rectangle, to_plane(camera, pixel)).value().homogeneous();
  };
  return render_street({camera.width, camera.height}, ray_at, place);
}

CalibratedCamera draw_calibration(const ImageSize& size, double hfov_deg, std::uint64_t lens) {
  const double aspect = std::hypot(1.0, static_cast<double>(size.height) / size.width);
  for (std::uint64_t attempt = 0;; ++attempt) {
    const Stream stream =
        substream(substream(make_stream(lens, "street lens"), std::lround(hfov_deg * 100)), attempt);
    CalibratedCamera c{
        "",
        pinhole_from_hfov(size.width, size.height, radians(hfov_deg + random_uniform(stream, 6, -1, 1))),
        {}};
    if (lens == 0) return c;
    c.pinhole.cx += size.width * random_uniform(stream, 0, -.03, .03);
    c.pinhole.cy += size.height * random_uniform(stream, 1, -.06, .06);
    const double r = std::tan(hfov_rad(c.pinhole) / 2) * aspect, r2 = r * r;
    const double K1 = random_uniform(stream, 2, -.35, .15), K2 = K1 * random_uniform(stream, 3, -.6, 0),
                 K3 = -.2 * K2;
    c.distortion = {K1 / r2, K2 / (r2 * r2), K3 / (r2 * r2 * r2), random_uniform(stream, 4, -.012, .012) / r,
                    random_uniform(stream, 5, -.012, .012) / r};
    if (certify_frame(c.distortion, c.pinhole, comfortably_one_to_one).valid()) return c;
  }
}

Dataset make_street_dataset(const std::filesystem::path& root, const StreetDatasetOptions& options) {
  struct Image {
    CalibratedCamera calibration;
    std::uint64_t place;
    std::filesystem::path file;
  };
  std::vector<Image> images;
  int lens_number = 0, first_place = 0;
  for (auto [part, count] :
       {std::pair{Part::train, options.train_places}, std::pair{Part::val, options.val_places},
        std::pair{Part::test, options.test_places}}) {
    std::string list;
    for (const ImageSize& size : options.sizes)
      for (int f = 0; f < options.fields_of_view; ++f)
        for (int l = 0; l < options.lenses_per_part; ++l) {
          const double hfov_deg = 35 + 75.0 * (f + .5) / options.fields_of_view;
          const std::string folder = fmt::format("{}x{}_hfov{:03.0f}/front_lens{:04}", size.width,
                                                 size.height, hfov_deg, ++lens_number);
          const CalibratedCamera calibration = draw_calibration(size, hfov_deg, l == 0 ? 0 : lens_number);
          Label label;
          label.camera = calibration.pinhole;
          label.distortion = calibration.distortion;
          label.fov_base_deg = degrees(hfov_rad(calibration.pinhole));
          label.part = part;
          write_json(root / folder / "calibration.json", to_json(label));
          for (int i = 0; i < count; ++i) {
            const std::string name = fmt::format("{}/{:06}.png", folder, i);
            images.push_back(
                {calibration, static_cast<std::uint64_t>(first_place + i + 1000 * f), root / name});
            list += name + "\n";
          }
        }
    write_file(root / "splits" / (to_string(part) + ".txt"), list);
    first_place += count;
  }
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    write_png(render_street(images[i].calibration, images[i].place), images[i].file);
  });
  return read_dataset(root);
}

}  // namespace cps
