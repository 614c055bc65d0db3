// One gzip-compressed message.
#include "proto/saved_match_file.h"

#include <fcntl.h>
#include <google/protobuf/io/gzip_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl.h>

#include <cerrno>
#include <cstring>

namespace cls::proto {
namespace {

using google::protobuf::io::FileInputStream;
using google::protobuf::io::FileOutputStream;
using google::protobuf::io::GzipInputStream;
using google::protobuf::io::GzipOutputStream;

constexpr const char* kFormat = "cls.saved-match";

std::string error_text(const std::string& path, int code) {
  return path + ": " + (code == 0 ? "write failed" : std::strerror(code));
}

}  // namespace

std::string write_saved_match(const std::string& path, saved::SavedMatch match) {
  match.set_format(kFormat);
  match.set_version(kSavedMatchVersion);

  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return error_text(path, errno);

  FileOutputStream file(descriptor);
  GzipOutputStream gzip(&file);
  const bool written = match.SerializeToZeroCopyStream(&gzip);
  const bool flushed = gzip.Close();
  const bool closed = file.Close();
  return written && flushed && closed ? "" : error_text(path, file.GetErrno());
}

std::string read_saved_match(const std::string& path, saved::SavedMatch& out) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return error_text(path, errno);

  FileInputStream file(descriptor);
  file.SetCloseOnDelete(true);
  GzipInputStream gzip(&file);
  if (!out.ParseFromZeroCopyStream(&gzip) || gzip.ZlibErrorMessage() != nullptr ||
      out.format() != kFormat) {
    return path + ": not a saved match, or truncated; save one with cls match --save-at";
  }

  if (out.version() > kSavedMatchVersion) {
    return path + ": version " + std::to_string(out.version()) +
           " of saved matches is newer than this cls reads (" + std::to_string(kSavedMatchVersion) +
           "); update cls";
  }
  return {};
}

}  // namespace cls::proto
