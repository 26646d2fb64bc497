// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_fingerprint_h
#define lumbricus_core_fingerprint_h

#include <boost/crc.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace lumbricus
{
  /** What tells one content of a file from another: its size [bytes] and its
   * CRC-32 (that of zlib and of Ethernet). */
  struct Fingerprint
  {
    std::uintmax_t size     = 0; ///< [bytes]
    std::uint32_t  checksum = 0; ///< CRC-32

    /** The largest size that can be. */
    static constexpr auto largest_size =
      std::numeric_limits<std::uintmax_t>::max();
    /** The largest checksum that can be. */
    static constexpr auto largest_checksum =
      std::numeric_limits<std::uint32_t>::max();

    /** Whether size and checksum are the same. */
    bool
    operator==(const Fingerprint &other) const
    {
      return size == other.size && checksum == other.checksum;
    }
  };



  /** The fingerprint of a content that grows. */
  class GrowingFingerprint
  {
  public:
    /** The content goes on with @p more. */
    void
    add(const std::string &more);

    /** The fingerprint of what there is so far. */
    Fingerprint
    value() const;

  private:
    std::uintmax_t     size = 0;
    boost::crc_32_type crc;
  };



  /** That of @p content. */
  Fingerprint
  fingerprint(const std::string &content);

  /** That of the first @p n_bytes of a regular file, or of all of it where it
   * is no longer; nothing where it cannot be read or is no regular file. */
  std::optional<GrowingFingerprint>
  fingerprint_of_file(const std::string   &file_name,
                      const std::uintmax_t n_bytes =
                        std::numeric_limits<std::uintmax_t>::max());
} // namespace lumbricus

#endif
