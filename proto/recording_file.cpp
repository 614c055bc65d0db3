// Delimited protobuf messages in gzip.
#include "proto/recording_file.h"

#include <fcntl.h>
#include <google/protobuf/io/gzip_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl.h>
#include <google/protobuf/util/delimited_message_util.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace cls::proto {
namespace {

using google::protobuf::io::FileInputStream;
using google::protobuf::io::FileOutputStream;
using google::protobuf::io::GzipInputStream;
using google::protobuf::io::GzipOutputStream;
using google::protobuf::util::ParseDelimitedFromZeroCopyStream;
using google::protobuf::util::SerializeDelimitedToZeroCopyStream;

constexpr const char* kFormat = "cls.rpc-recording";
constexpr int kVersion = 1;

std::string reason(const std::string& path, int code) { return path + ": " + std::strerror(code); }

GzipOutputStream::Options fast() {
  GzipOutputStream::Options options;
  // A State a millisecond: speed counts for more than the last tenth of the size.
  options.compression_level = 1;
  return options;
}

}  // namespace

class RecordingWriter::File {
 public:
  File(std::string name, int descriptor)
      : path(std::move(name)), file(descriptor), gzip(&file, fast()) {}

  std::string path;
  FileOutputStream file;
  GzipOutputStream gzip;
  bool good = true;
  bool closed = false;
};

RecordingWriter::RecordingWriter(std::unique_ptr<File> file) : file_(std::move(file)) {}
RecordingWriter::~RecordingWriter() { close(); }

std::unique_ptr<RecordingWriter> RecordingWriter::create(const std::string& path,
                                                         const recording::RecordingHeader& header,
                                                         std::string& error) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    error = reason(path, errno);
    return nullptr;
  }
  auto file = std::make_unique<File>(path, descriptor);
  recording::RecordingHeader complete = header;
  complete.set_format(kFormat);
  complete.set_version(kVersion);
  file->good = SerializeDelimitedToZeroCopyStream(complete, &file->gzip);
  return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(file)));
}

void RecordingWriter::write(const recording::RecordedCall& call) {
  file_->good = file_->good && SerializeDelimitedToZeroCopyStream(call, &file_->gzip);
}

std::string RecordingWriter::close() {
  if (std::exchange(file_->closed, true)) return {};
  const bool flushed = file_->gzip.Close();
  const bool closed = file_->file.Close();
  if (file_->good && flushed && closed) return {};
  const int code = file_->file.GetErrno();
  return code == 0 ? file_->path + ": cannot be written" : reason(file_->path, code);
}

class RecordingReader::File {
 public:
  explicit File(int descriptor) : file(descriptor), gzip(&file) { file.SetCloseOnDelete(true); }

  FileInputStream file;
  GzipInputStream gzip;
};

RecordingReader::RecordingReader(std::string path, std::unique_ptr<File> file)
    : path_(std::move(path)), file_(std::move(file)) {}
RecordingReader::~RecordingReader() = default;

std::unique_ptr<RecordingReader> RecordingReader::open(const std::string& path,
                                                       std::string& error) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    error = reason(path, errno);
    return nullptr;
  }
  std::unique_ptr<RecordingReader> reader(
      new RecordingReader(path, std::make_unique<File>(descriptor)));
  bool clean_end = false;
  const bool read =
      ParseDelimitedFromZeroCopyStream(&reader->header_, &reader->file_->gzip, &clean_end);
  if (!read || reader->header_.format() != kFormat) {
    error = path + ": not a recording of rpcs (cls match --record-rpc)";
    return nullptr;
  }
  if (reader->header_.version() != kVersion) {
    error = path + ": a recording of version " + std::to_string(reader->header_.version()) +
            "; this cls reads version " + std::to_string(kVersion);
    return nullptr;
  }
  return reader;
}

bool RecordingReader::next(recording::RecordedCall& call) {
  call.Clear();
  bool clean_end = false;
  if (ParseDelimitedFromZeroCopyStream(&call, &file_->gzip, &clean_end)) {
    ++calls_;
    return true;
  }
  const bool broken = !clean_end || file_->gzip.ZlibErrorMessage() != nullptr;
  if (broken) damage_ = path_ + ": damaged after call " + std::to_string(calls_);
  return false;
}

}  // namespace cls::proto
