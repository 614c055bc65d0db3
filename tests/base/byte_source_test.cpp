// Byte sources: plain, gzip, truncated and corrupt; lines and blocks from an input buffer.
#include "base/io/byte_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>

#include "base/io/input_buffer.h"
#include "tests/support/temporary_folder.h"

namespace cls::base {
namespace {

std::string gzip(const std::string& text) {
  z_stream stream = {};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);

  std::string out(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string some_text() {
  std::string text;
  for (int i = 0; i < 30000; ++i) text += "line " + std::to_string(i * 7919) + "\n";
  return text;
}

struct Contents {
  std::string bytes;
  std::string error;
};

Contents read_in_chunks(ByteSource& source, std::size_t block = 1000) {
  Contents result;
  std::string buffer(block, '\0');
  while (const std::size_t count = source.read(buffer.data(), buffer.size())) {
    result.bytes.append(buffer, 0, count);
  }
  result.error = source.error();
  return result;
}

Contents decompress_all(std::string_view bytes) {
  return read_in_chunks(*decompress(std::make_unique<MemorySource>(bytes)));
}

TEST(Decompress, PassesPlainBytesThrough) {
  for (const std::string& text :
       {std::string(), std::string("a"), std::string("\x1f"), some_text()}) {
    const Contents result = decompress_all(text);
    EXPECT_EQ(result.bytes, text);
    EXPECT_EQ(result.error, "");
  }
}

TEST(Decompress, ReadsGzipOfOneOrMoreMembers) {
  const std::string text = some_text();
  const std::string once = gzip(text);
  EXPECT_EQ(decompress_all(once).bytes, text);
  const Contents twice = decompress_all(once + gzip("the end\n") + std::string(512, '\0'));
  EXPECT_EQ(twice.bytes, text + "the end\n");
  EXPECT_EQ(twice.error, "");
}

// "one\ntwo\n", packed by the programs xz and zstd.
constexpr std::string_view kXz{
    "\xfd\x37\x7a\x58\x5a\x00\x00\x04\xe6\xd6\xb4\x46\x02\x00\x21\x01\x16\x00\x00\x00"
    "\x74\x2f\xe5\xa3\x01\x00\x07\x6f\x6e\x65\x0a\x74\x77\x6f\x0a\x00\x51\xab\x9e\xaf"
    "\x57\x75\x70\x49\x00\x01\x20\x08\xbb\x19\xd9\xbb\x1f\xb6\xf3\x7d\x01\x00\x00\x00"
    "\x00\x04\x59\x5a",
    64};
constexpr std::string_view kZstd{
    "\x28\xb5\x2f\xfd\x04\x58\x41\x00\x00\x6f\x6e\x65\x0a\x74\x77\x6f\x0a\xe6\xa6\x0e"
    "\x40",
    21};

TEST(Decompress, ReadsXzAndZstdOfOneOrMoreMembers) {
  for (const std::string_view packed : {kXz, kZstd}) {
    const std::string once(packed);
    EXPECT_EQ(decompress_all(once).bytes, "one\ntwo\n");
    const Contents twice = decompress_all(once + once);
    EXPECT_EQ(twice.bytes, "one\ntwo\none\ntwo\n");
    EXPECT_EQ(twice.error, "");
    EXPECT_THAT(decompress_all(once.substr(0, once.size() - 3)).error,
                testing::EndsWith(" data is truncated"));
    EXPECT_THAT(decompress_all(once + "something else").error,
                testing::EndsWith(" data is corrupt"));
  }
}

TEST(Decompress, SkipsAByteOrderMark) {
  const std::string text = "\xef\xbb\xbfULG5\n\xef\xbb\xbf";
  for (const std::string& bytes : {text, gzip(text)}) {
    EXPECT_EQ(decompress_all(bytes).bytes, "ULG5\n\xef\xbb\xbf");
  }
  EXPECT_EQ(decompress_all("\xef\xbb\xbf").bytes, "");
  EXPECT_EQ(decompress_all("\xef\xbb").bytes, "\xef\xbb");
}

TEST(OpenSource, NamesTheProgramThatUnpacksAnArchive) {
  const tests::TemporaryFolder folder;
  const std::string path = folder.path() / "logs";
  const auto error_of = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    const auto source = open_source(path);
    return source ? std::string() : source.error().message;
  };
  const std::string tar = std::string(257, 'a') + "ustar" + std::string(250, '\0');
  const std::string end = "; unpack it first: ";
  EXPECT_EQ(error_of("PK\x03\x04..."),
            "'" + path + "' is a zip archive" + end + "unzip '" + path + "'");
  EXPECT_EQ(error_of("BZh9..."),
            "'" + path + "' is compressed with bzip2" + end + "bunzip2 -k '" + path + "'");
  for (const std::string& bytes : {tar, gzip(tar)}) {
    EXPECT_EQ(error_of(bytes), "'" + path + "' is a tar archive" + end + "tar -xf '" + path + "'");
  }
  EXPECT_EQ(error_of("ULG5\n"), "");
}

TEST(Decompress, ReturnsBytesBeforeTruncation) {
  const std::string text = some_text();
  const std::string whole = gzip(text);

  for (const std::size_t size : {whole.size() / 2, whole.size() - 1, std::size_t{12}}) {
    const Contents result = decompress_all(std::string_view(whole).substr(0, size));
    EXPECT_EQ(result.error, "gzip data is truncated");
    EXPECT_EQ(result.bytes, text.substr(0, result.bytes.size()));
    if (size > 1000) {
      EXPECT_GT(result.bytes.size(), text.size() / 4);
    }
  }
}

TEST(Decompress, ReportsCorruptData) {
  std::string bytes = gzip(some_text());
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  EXPECT_EQ(decompress_all(bytes).error.substr(0, 20), "gzip data is corrupt");
}

TEST(OpenSource, ReadsFileAndReportsMissingFile) {
  const tests::TemporaryFolder folder;
  const std::string path = (folder.path() / "game.rcg").string();
  std::ofstream(path) << "ULG6\n";
  auto source = open_source(path);

  ASSERT_TRUE(source);
  EXPECT_EQ(read_in_chunks(**source).bytes, "ULG6\n");
  EXPECT_EQ(open_source("/nonexistent/game.rcg").error().message,
            "cannot open '/nonexistent/game.rcg': No such file or directory");
  EXPECT_EQ(open_source(folder.path().string()).error().message,
            "cannot read '" + folder.path().string() + "': it is a folder");
}

// Returns a few bytes per read.
class SlowSource : public ByteSource {
 public:
  SlowSource(std::string_view bytes, std::size_t step) : bytes_(bytes), step_(step) {}
  std::size_t read(char* to, std::size_t size) override {
    return bytes_.read(to, std::min(size, step_));
  }

 private:
  MemorySource bytes_;
  std::size_t step_;
};

TEST(InputBuffer, FindsLinesForAllReadSizes) {
  const std::string text = some_text() + "\n\nthe rest";

  for (const std::size_t step : {std::size_t{1000000}, std::size_t{4096}, std::size_t{13}}) {
    SlowSource source(text, step);
    InputBuffer input(source);
    std::string again;
    std::string_view line;
    InputBuffer::Line kind;
    std::uint64_t number = 0;
    while ((kind = input.next_line(line)) == InputBuffer::Line::kWhole) {
      EXPECT_EQ(input.offset(), again.size());
      EXPECT_EQ(input.line_number(), ++number);
      again += line;
      again += '\n';
      ASSERT_EQ(line.data()[line.size()], '\n');
    }
    EXPECT_EQ(kind, InputBuffer::Line::kUnfinished);
    EXPECT_EQ(line, "the rest");
    EXPECT_EQ(again + "the rest", text);
    EXPECT_EQ(input.next_line(line), InputBuffer::Line::kEnd);
  }
}

TEST(InputBuffer, SkipsLineThatIsTooLong) {
  const std::string text = "a\n" + std::string(5 * 1024 * 1024, 'x') + "\nb\n";
  MemorySource source(text);
  InputBuffer input(source);
  std::string_view line;

  EXPECT_EQ(input.next_line(line), InputBuffer::Line::kWhole);
  EXPECT_EQ(input.next_line(line), InputBuffer::Line::kTooLong);
  EXPECT_EQ(line.substr(0, 3), "xxx");
  EXPECT_EQ(input.next_line(line), InputBuffer::Line::kWhole);
  EXPECT_EQ(line, "b");
  EXPECT_EQ(input.line_number(), 3u);
  EXPECT_EQ(input.offset(), text.size() - 2);
}

TEST(InputBuffer, ReturnsBlocks) {
  MemorySource source("abcdefgh");
  InputBuffer input(source);
  EXPECT_EQ(input.peek(3), "abc");
  EXPECT_EQ(input.take(3), "abc");
  EXPECT_EQ(input.take(3), "def");
  EXPECT_EQ(input.offset(), 3u);
  EXPECT_EQ(input.take(3), "gh");
  EXPECT_EQ(input.take(3), "");
}

}  // namespace
}  // namespace cls::base
