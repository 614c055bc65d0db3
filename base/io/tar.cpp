// Blocks of 512 bytes: a header and the bytes of each file.
#include "base/io/tar.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace cls::base {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kMaxName = 100;
constexpr std::uint64_t kMaxSize = (std::uint64_t{1} << 33) - 1;  // eleven octal digits

// Offsets of the fields of a header.
constexpr std::size_t kMode = 100;
constexpr std::size_t kUser = 108;
constexpr std::size_t kGroup = 116;
constexpr std::size_t kSize = 124;
constexpr std::size_t kTime = 136;
constexpr std::size_t kChecksum = 148;
constexpr std::size_t kType = 156;
constexpr std::size_t kMagic = 257;

void put(std::string& header, std::size_t offset, std::string_view text) {
  header.replace(offset, text.size(), text);
}

}  // namespace

Result<void> append_to_tar(const std::string& name, std::string_view bytes, std::int64_t time,
                           ByteSink& sink) {
  if (name.empty() || name.size() > kMaxName) {
    return Error{fmt::format("'{}': a name in an archive has 1 to {} bytes", name, kMaxName)};
  }
  if (bytes.size() > kMaxSize) return Error{fmt::format("'{}': too large for an archive", name)};

  std::string header(kBlock, '\0');
  put(header, 0, name);
  put(header, kMode, "0000644");
  put(header, kUser, "0000000");
  put(header, kGroup, "0000000");
  put(header, kSize, fmt::format("{:011o}", bytes.size()));
  put(header, kTime, fmt::format("{:011o}", std::max<std::int64_t>(time, 0)));
  put(header, kChecksum, "        ");  // counts as spaces
  put(header, kType, "0");
  put(header, kMagic, std::string_view("ustar\00000", 8));

  const unsigned sum = std::accumulate(
      header.begin(), header.end(), 0U,
      [](unsigned so_far, char c) { return so_far + static_cast<unsigned char>(c); });
  put(header, kChecksum, fmt::format("{:06o}", sum));
  header[kChecksum + 6] = '\0';

  sink.write(header);
  sink.write(bytes);
  const std::size_t rest = bytes.size() % kBlock;
  if (rest > 0) sink.write(std::string(kBlock - rest, '\0'));
  return {};
}

void end_tar(ByteSink& sink) { sink.write(std::string(2 * kBlock, '\0')); }

}  // namespace cls::base
