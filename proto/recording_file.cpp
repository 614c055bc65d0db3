// Length-delimited protobuf messages, gzip-compressed.
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

std::string error_text(const std::string& path, int code) {
  return path + ": " + std::strerror(code);
}

GzipOutputStream::Options fast() {
  GzipOutputStream::Options options;
  // About one State per millisecond: speed matters more than the last 10 % of size.
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
  bool ok = true;
  bool closed = false;
};

RecordingWriter::RecordingWriter(std::unique_ptr<File> file) : file_(std::move(file)) {}
RecordingWriter::~RecordingWriter() { close(); }

std::unique_ptr<RecordingWriter> RecordingWriter::create(const std::string& path,
                                                         const recording::RecordingHeader& header,
                                                         std::string& error) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    error = error_text(path, errno);
    return nullptr;
  }

  auto file = std::make_unique<File>(path, descriptor);
  recording::RecordingHeader complete = header;
  complete.set_format(kFormat);
  complete.set_version(kRecordingVersion);
  file->ok = SerializeDelimitedToZeroCopyStream(complete, &file->gzip);
  return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(file)));
}

void RecordingWriter::write(const recording::RecordedCall& call) {
  file_->ok = file_->ok && SerializeDelimitedToZeroCopyStream(call, &file_->gzip);
}

std::string RecordingWriter::close() {
  if (std::exchange(file_->closed, true)) return {};
  const bool flushed = file_->gzip.Close();
  const bool closed = file_->file.Close();

  if (file_->ok && flushed && closed) return {};
  const int code = file_->file.GetErrno();
  return code == 0 ? file_->path + ": write failed" : error_text(file_->path, code);
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
    error = error_text(path, errno);
    return nullptr;
  }

  std::unique_ptr<RecordingReader> reader(
      new RecordingReader(path, std::make_unique<File>(descriptor)));
  bool clean_end = false;
  const bool read =
      ParseDelimitedFromZeroCopyStream(&reader->header_, &reader->file_->gzip, &clean_end);
  if (!read || reader->header_.format() != kFormat) {
    error = path + ": not an RPC recording; record one with cls match --record-rpc";
    return nullptr;
  }

  if (const int version = reader->header_.version(); version > kRecordingVersion) {
    error = path + ": version " + std::to_string(version) +
            " of recordings is newer than this cls reads (" + std::to_string(kRecordingVersion) +
            "); update cls";
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

  const bool corrupt = !clean_end || file_->gzip.ZlibErrorMessage() != nullptr;
  if (corrupt) parse_error_ = path_ + ": corrupt or truncated after call " + std::to_string(calls_);
  return false;
}

}  // namespace cls::proto
