#include "tests/trainer/deepcalib/sphere_street.h"

#include <fmt/format.h>

#include <utility>

#include "dataset/labels/model_label.h"
#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/warp/warp_options.h"
#include "files/files.h"
#include "random/counter_hash.h"
#include "tests/trainer/street.h"
#include "trainer/deepcalib/sphere_target.h"

namespace cps {

ModelCamera draw_sphere(int size, std::uint64_t lens) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    const Stream stream = substream(make_stream(lens, "sphere"), attempt);
    ModelCamera camera = to_model_camera({random_uniform(stream, 0), random_uniform(stream, 1)}, size, size);
    if (!certify_frame(camera, warpable).valid) continue;
    camera.name = "front";
    return camera;
  }
}

Dataset make_sphere_dataset(const std::filesystem::path& root, const SphereDatasetOptions& options) {
  std::uint64_t number = 0;
  for (const auto& [part, lenses] :
       {std::pair{Part::train, options.train_lenses}, std::pair{Part::val, options.val_lenses},
        std::pair{Part::test, options.test_lenses}}) {
    std::string list;
    for (int l = 0; l < lenses; ++l) {
      const ModelCamera camera = draw_sphere(options.size, ++number);
      const RayRegion region = certify_frame(camera, warpable).region;
      const std::string folder = fmt::format("{0}x{0}_spheres/front_lens{1:04}", options.size, number);
      ModelLabel label = model_label(camera);
      label.part = part;
      write_json(root / folder / "calibration.json", to_json(label));
      const auto ray_at = [&](const Eigen::Vector2d& pixel) -> Eigen::Vector3d {
        return unproject(camera.lens, region, to_plane(camera.pinhole, pixel)).value();
      };
      const std::string name = fmt::format("{}/{:06}.png", folder, number);
      write_png(render_street({options.size, options.size}, ray_at, number), root / name);
      list += name + "\n";
    }
    write_file(root / "splits" / (to_string(part) + ".txt"), list);
  }
  return read_dataset(root, LensFamilies::any);
}

}  // namespace cps
