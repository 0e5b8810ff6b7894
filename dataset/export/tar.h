#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "files/pieces.h"

/// POSIX ustar archives (IEEE Std 1003.1, pax, "ustar Interchange Format") of plain files. Owner, group and
/// time are 0, so that the same files give the same bytes. Written by hand because that is all there is to
/// it.
namespace cps {

/// Appends a file's header, bytes and padding. Throws std::runtime_error when the header cannot hold its name
/// (100 bytes) or size (8 GiB).
void add_to_tar(const Append& append, const std::string& name, std::span<const char> bytes);

/// Appends what ends an archive.
void end_tar(const Append& append);

/// Bytes that a file of this size takes in an archive, and those of its end.
std::uint64_t size_in_tar(std::uint64_t bytes);
inline constexpr std::uint64_t tar_end_bytes = 1024;

}  // namespace cps
