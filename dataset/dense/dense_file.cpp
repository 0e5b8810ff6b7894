#include "dataset/dense/dense_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "dataset/pixels/codec.h"
#include "files/png.h"

namespace cps {
namespace {

bool is_png(DenseLabel label) {
  return label == DenseLabel::instance || label == DenseLabel::semantic;
}

std::vector<std::string> channel_names(DenseLabel label) {
  switch (label) {
    case DenseLabel::depth:
      return {"Z"};
    case DenseLabel::normal:
    case DenseLabel::rays:
      return {"X", "Y", "Z"};
    case DenseLabel::up:
      return {"X", "Y"};
    default:
      return {"Y"};  // also what OpenImageIO calls the gray of a PNG
  }
}

/// `X, Y, Z of float`
std::string described(const OIIO::ImageSpec& spec) {
  return fmt::format("{} of {}", fmt::join(spec.channelnames, ", "),
                     spec.channelformats.empty() ? spec.format.c_str() : "several types");
}

/// Any pixels at all, as many channels, and of this type.
bool holds(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& wanted) {
  return spec.width > 0 && spec.height > 0 && spec.nchannels == wanted.nchannels &&
         spec.format == wanted.format;
}

/// That, with the names of the channels, in any order.
bool has_channels(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& wanted) {
  const auto is_there = [&](const std::string& name) { return spec.channelindex(name) >= 0; };
  return holds(spec, wanted) && spec.channelformats.empty() &&
         std::ranges::all_of(wanted.channelnames, is_there);
}

}  // namespace

std::filesystem::path dense_file(const std::filesystem::path& image, DenseLabel label) {
  return std::filesystem::path(image).replace_extension(to_string(label) + (is_png(label) ? ".png" : ".exr"));
}

bool is_dense_file(const std::filesystem::path& file) {
  const std::filesystem::path image = file.stem().stem() += ".png";
  const auto is_named = [&](const char* label) {
    return file.filename() == dense_file(image, dense_label_from(label));
  };
  return std::ranges::any_of(dense_label_names, is_named);
}

OIIO::ImageSpec dense_spec(DenseLabel label, ImageSize size) {
  const std::vector<std::string> names = channel_names(label);
  OIIO::ImageSpec spec(size.width, size.height, static_cast<int>(names.size()),
                       is_png(label) ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT);
  spec.channelnames = names;
  return spec;
}

std::string encode_dense(const OIIO::ImageBuf& pixels, DenseLabel label) {
  const OIIO::ImageSpec& spec = pixels.spec();
  const OIIO::ImageSpec wanted = dense_spec(label, {spec.width, spec.height});
  if (!holds(spec, wanted))
    throw std::runtime_error(fmt::format("{}: needs pixels with {}, has {} x {} with {}", to_string(label),
                                         described(wanted), spec.width, spec.height, described(spec)));
  return is_png(label) ? encode_png(pixels) : encode_exr(pixels, wanted.format, wanted.channelnames);
}

OIIO::ImageBuf read_dense(const std::filesystem::path& file, DenseLabel label) {
  try {
    const std::unique_ptr<OIIO::ImageInput> in = open_image(file);
    const OIIO::ImageSpec& spec = in->spec();
    const OIIO::ImageSpec wanted = dense_spec(label, {spec.width, spec.height});
    if (!has_channels(spec, wanted))
      throw std::runtime_error(fmt::format("needs {}, has {}", described(wanted), described(spec)));
    return channels_of(*in, wanted.format, wanted.channelnames);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: cannot be read as the label {} ({}): make the dataset again",
                                         file.string(), to_string(label), error.what()));
  }
}

}  // namespace cps
