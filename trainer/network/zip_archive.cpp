#include "trainer/network/zip_archive.h"

#include <libdeflate.h>

#include <cstdint>
#include <stdexcept>

namespace cps {
namespace {

constexpr std::uint32_t local_header = 0x04034b50, central_header = 0x02014b50, end_record = 0x06054b50,
                        end_record_64 = 0x06064b50;
constexpr std::uint32_t in_64 = 0xffffffff;  ///< marks a size or offset that is stored in the extra field

void put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i & 0xff);
}

std::uint64_t get(std::string_view bytes, std::size_t at, int count) {
  if (at > bytes.size() || bytes.size() - at < static_cast<std::size_t>(count))
    throw std::runtime_error("is cut short");
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
  return value;
}

std::string_view part(std::string_view bytes, std::size_t at, std::size_t length) {
  if (at > bytes.size() || bytes.size() - at < length) throw std::runtime_error("is cut short");
  return bytes.substr(at, length);
}

/// The fields common to both headers: version, flags, method, time, date, CRC, two sizes.
void put_common(std::string& out, std::string_view data) {
  put(out, 20, 2);
  put(out, 0, 4);  // flags; method: stored
  put(out, 0, 2);
  put(out, 0x21, 2);  // 1 January 1980, always: the same weights give the same bytes
  put(out, libdeflate_crc32(0, data.data(), data.size()), 4);
  put(out, data.size(), 4);
  put(out, data.size(), 4);
}

/// Number of entries and offset of the first central header.
std::pair<std::uint64_t, std::uint64_t> directory(std::string_view bytes) {
  const std::size_t min_size = 22, max_comment = 65535;
  for (std::size_t back = min_size; back <= bytes.size() && back <= min_size + max_comment; ++back) {
    const std::size_t at = bytes.size() - back;
    if (get(bytes, at, 4) != end_record) continue;
    if (get(bytes, at + 16, 4) != in_64) return {get(bytes, at + 10, 2), get(bytes, at + 16, 4)};
    const std::size_t locator = at - 20;  // of the end record with 64-bit numbers
    const std::size_t at_64 = get(bytes, locator + 8, 8);
    if (get(bytes, at_64, 4) != end_record_64) break;
    return {get(bytes, at_64 + 32, 8), get(bytes, at_64 + 48, 8)};
  }
  throw std::runtime_error("is not a ZIP archive");
}

}  // namespace

std::string zip_stored(const std::vector<std::pair<std::string, std::string_view>>& entries) {
  std::string out, central;
  for (const auto& [name, data] : entries) {
    if (out.size() + data.size() > 0xfff00000u) throw std::runtime_error("would be larger than 4 GB");
    const std::size_t offset = out.size();
    put(out, local_header, 4);
    put_common(out, data);
    put(out, name.size(), 2);
    const std::size_t padding = (64 - (offset + 30 + name.size() + 4) % 64) % 64;
    put(out, 4 + padding, 2);
    out += name;
    put(out, 0x4246, 2);  // the id of PyTorch's padding field, "FB"
    put(out, padding, 2);
    out.append(padding, 'Z');
    out += data;

    put(central, central_header, 4);
    put(central, 20, 2);
    put_common(central, data);
    put(central, name.size(), 2);
    put(central, 0, 2 + 2 + 2 + 2 + 4);  // extra, comment, disk, attributes
    put(central, offset, 4);
    central += name;
  }
  const std::size_t start = out.size();
  out += central;
  put(out, end_record, 4);
  put(out, 0, 4);
  put(out, entries.size(), 2);
  put(out, entries.size(), 2);
  put(out, central.size(), 4);
  put(out, start, 4);
  put(out, 0, 2);
  return out;
}

std::map<std::string, std::string_view> unzip_stored(std::string_view bytes) {
  std::map<std::string, std::string_view> entries;
  auto [count, at] = directory(bytes);
  for (std::uint64_t e = 0; e < count; ++e) {
    if (get(bytes, at, 4) != central_header) throw std::runtime_error("has a damaged list of entries");
    const std::size_t name_length = get(bytes, at + 28, 2), extra_length = get(bytes, at + 30, 2),
                      comment_length = get(bytes, at + 32, 2);
    std::uint64_t length = get(bytes, at + 24, 4), offset = get(bytes, at + 42, 4);
    const std::string name(part(bytes, at + 46, name_length));
    // Numbers that do not fit into 32 bits are in extra field 1, in this order: size, stored size, offset.
    std::size_t extra = at + 46 + name_length;
    for (const std::size_t end = extra + extra_length; extra + 4 <= end;) {
      const std::size_t kind = get(bytes, extra, 2), size = get(bytes, extra + 2, 2);
      std::size_t field = extra + 4;
      if (kind == 1) {
        if (length == in_64) length = get(bytes, field, 8), field += 8;
        if (get(bytes, at + 20, 4) == in_64) field += 8;
        if (offset == in_64) offset = get(bytes, field, 8);
      }
      extra += 4 + size;
    }
    if (get(bytes, at + 10, 2) != 0) throw std::runtime_error("has a compressed entry, " + name);
    if (get(bytes, offset, 4) != local_header) throw std::runtime_error("has a damaged entry, " + name);
    const std::size_t data = offset + 30 + get(bytes, offset + 26, 2) + get(bytes, offset + 28, 2);
    const std::string_view content = part(bytes, data, length);
    if (libdeflate_crc32(0, content.data(), content.size()) != get(bytes, at + 16, 4))
      throw std::runtime_error("has a damaged entry, " + name);
    if (!entries.emplace(name, content).second) throw std::runtime_error("has two entries named " + name);
    at += 46 + name_length + extra_length + comment_length;
  }
  return entries;
}

}  // namespace cps
