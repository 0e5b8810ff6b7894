#pragma once

#include <filesystem>
#include <iosfwd>

#include "renderer/render.h"

namespace cps {

/// Renders in passes that double the number of samples. After each, prints a line of CSV: samples, CPU
/// seconds so far, and the error against the reference. Returns the picture. Throws std::runtime_error that
/// names the reference's file.
OIIO::ImageBuf render_against(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                              const std::filesystem::path& reference, std::ostream& csv,
                              RenderSummary* summary);

}  // namespace cps
