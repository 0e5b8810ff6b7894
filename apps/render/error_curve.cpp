#include "apps/render/error_curve.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <stdexcept>

#include "renderer/image_error.h"

namespace cps {

OIIO::ImageBuf render_against(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                              const std::filesystem::path& reference, std::ostream& csv,
                              RenderSummary* summary) {
  OIIO::ImageBuf expected(reference.string());
  if (!expected.read(0, 0, true, OIIO::TypeDesc::FLOAT))
    throw std::runtime_error(reference.string() + ": " + expected.geterror());
  csv << "samples,cpu_s,rmse,rel_mse,bias\n";
  OIIO::ImageBuf sum;
  RenderSummary so_far;
  for (int first = 0; first < options.samples;) {
    const SampleRange range{first, std::min(std::max(first, 1), options.samples - first)};
    RenderSummary pass;
    const OIIO::ImageBuf mean = render_samples(scene, camera, options, range, &pass);
    const OIIO::ImageBuf part = OIIO::ImageBufAlgo::mul(mean, static_cast<float>(range.count));
    sum = first == 0 ? part : OIIO::ImageBufAlgo::add(sum, part);
    first += range.count;
    so_far.wall_s += pass.wall_s;
    so_far.cpu_s += pass.cpu_s;
    so_far.samples += pass.samples;
    so_far.rays += pass.rays;
    const ImageError error =
        image_error(OIIO::ImageBufAlgo::mul(sum, 1.0f / static_cast<float>(first)), expected);
    fmt::print(csv, "{},{:.4f},{:.6g},{:.6g},{:.6g}\n", first, so_far.cpu_s, error.rmse, error.rel_mse,
               error.bias);
    csv.flush();
  }
  if (summary) *summary = so_far;
  return OIIO::ImageBufAlgo::mul(sum, 1.0f / static_cast<float>(options.samples));
}

}  // namespace cps
