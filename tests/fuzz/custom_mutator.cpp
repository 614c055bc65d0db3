// Mutations for fuzzers whose input is text: half of them by structure. What is compressed is
// mutated as the text that it is.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/io/byte_source.h"
#include "base/io/gzip_sink.h"
#include "tests/support/structure_mutator.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

constexpr std::string_view kGzip = "\x1f\x8b";
constexpr std::size_t kMaxText = 1 << 16;

std::string decompressed(std::string_view bytes) {
  const auto source = cls::base::decompress(std::make_unique<cls::base::MemorySource>(bytes));
  std::string text(kMaxText, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const std::size_t count = source->read(text.data() + size, text.size() - size);
    if (count == 0) break;
    size += count;
  }
  text.resize(size);
  return text;
}

std::string compressed(std::string_view text) {
  auto bytes = std::make_unique<cls::base::StringSink>();
  const cls::base::StringSink& written = *bytes;
  cls::base::GzipSink sink(std::move(bytes));
  sink.write(text);
  static_cast<void>(sink.close());
  return written.bytes();
}

std::string mutated(std::string text, std::size_t max_size, std::uint32_t seed) {
  if (seed % 2 == 0) return cls::tests::StructureMutator(seed).mutate(std::move(text), max_size);
  const std::size_t size = text.size();
  text.resize(std::max(size, max_size));
  text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, max_size));
  return text;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, std::uint32_t seed) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::string result;
  // One in eight stays as it is, so that damage of the compressed bytes is tried, too.
  if (bytes.starts_with(kGzip) && seed % 8 != 1) {
    result = compressed(mutated(decompressed(bytes), kMaxText, seed));
  }
  if (result.empty() || result.size() > max_size) {
    result = mutated(std::string(bytes), max_size, seed);
  }
  std::copy(result.begin(), result.end(), data);
  return result.size();
}
