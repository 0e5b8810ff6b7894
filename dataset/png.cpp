#include "dataset/png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <vector>

#include "dataset/files.h"

namespace cps {

std::string encode_png(const OIIO::ImageBuf& image) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> png = OIIO::ImageOutput::create("png");
  OIIO::ImageSpec spec(image.spec().width, image.spec().height, image.spec().nchannels,
                       OIIO::TypeDesc::UINT8);
  spec.attribute("png:compressionLevel", 1);
  spec.attribute("png:filter", 32);  // PNG_FILTER_UP
  spec.attribute("oiio:ColorSpace", "sRGB");
  const bool is_written = png && png->set_ioproxy(&memory) && png->open("image.png", spec) &&
                          png->write_image(OIIO::TypeDesc::UINT8, image.localpixels()) && png->close();
  if (!is_written)
    throw std::runtime_error("PNG encoding failed: " + (png ? png->geterror() : OIIO::geterror()));
  return {bytes.begin(), bytes.end()};
}

std::string pixels_sha256(const OIIO::ImageBuf& image) {
  const auto* pixels = static_cast<const char*>(image.localpixels());
  return sha256({pixels, image.spec().image_bytes()});
}

}  // namespace cps
