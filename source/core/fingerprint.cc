// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/fingerprint.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace lumbricus
{
  void
  GrowingFingerprint::add(const std::string &more)
  {
    crc.process_bytes(more.data(), more.size());
    size += more.size();
  }



  Fingerprint
  GrowingFingerprint::value() const
  {
    return {size, static_cast<std::uint32_t>(crc.checksum())};
  }



  Fingerprint
  fingerprint(const std::string &content)
  {
    GrowingFingerprint of_content;
    of_content.add(content);
    return of_content.value();
  }



  std::optional<GrowingFingerprint>
  fingerprint_of_file(const std::string   &file_name,
                      const std::uintmax_t n_bytes)
  {
    // In pieces, because a mesh may be larger than what memory is left.
    constexpr std::uintmax_t piece = 1 << 20;

    std::error_code error;
    if (!std::filesystem::is_regular_file(file_name, error))
      return {};
    std::ifstream      in(file_name, std::ios::binary);
    GrowingFingerprint found;
    std::string        content;
    while (in && found.value().size < n_bytes)
      {
        content.resize(std::min(piece, n_bytes - found.value().size));
        in.read(content.data(), content.size());
        content.resize(in.gcount());
        found.add(content);
      }
    if (in.bad() || !in.is_open())
      return {};
    return found;
  }
} // namespace lumbricus
