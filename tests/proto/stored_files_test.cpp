// Files of recorded RPCs and of saved matches: those of later versions are refused with one line.
#include <fcntl.h>
#include <google/protobuf/io/gzip_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl.h>
#include <google/protobuf/util/delimited_message_util.h>
#include <gtest/gtest.h>

#include <string>

#include "proto/recording_file.h"
#include "proto/saved_match_file.h"
#include "tests/support/temporary_folder.h"

namespace cls::proto {
namespace {

class StoredFile : public testing::Test {
 protected:
  // Calls `write` with the compressed stream of the file.
  template <typename Write>
  void put(Write write) const {
    const int descriptor = ::open(path().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ASSERT_GE(descriptor, 0);
    google::protobuf::io::FileOutputStream file(descriptor);
    file.SetCloseOnDelete(true);
    google::protobuf::io::GzipOutputStream gzip(&file);
    ASSERT_TRUE(write(gzip));
  }
  void put_recording(const std::string& format, int version) const {
    recording::RecordingHeader header;
    header.set_format(format);
    header.set_version(version);
    put([&](auto& out) {
      return google::protobuf::util::SerializeDelimitedToZeroCopyStream(header, &out);
    });
  }
  void put_match(const std::string& format, int version) const {
    saved::SavedMatch match;
    match.set_format(format);
    match.set_version(version);
    put([&](auto& out) { return match.SerializeToZeroCopyStream(&out); });
  }
  std::string recording_error() const {
    std::string error;
    RecordingReader::open(path(), error);
    return error;
  }
  std::string match_error() const {
    saved::SavedMatch match;
    return read_saved_match(path(), match);
  }
  std::string path() const { return (folder_.path() / "file").string(); }

  cls::tests::TemporaryFolder folder_;
};

TEST_F(StoredFile, RecordingOfALaterVersionIsRefused) {
  put_recording("cls.rpc-recording", kRecordingVersion);
  EXPECT_EQ(recording_error(), "");
  put_recording("cls.rpc-recording", kRecordingVersion + 1);
  EXPECT_EQ(recording_error(),
            path() + ": version 2 of recordings is newer than this cls reads (1); update cls");
  put_recording("cls.other", kRecordingVersion);
  EXPECT_EQ(recording_error(),
            path() + ": not an RPC recording; record one with cls match --record-rpc");
}

TEST_F(StoredFile, SavedMatchOfALaterVersionIsRefused) {
  put_match("cls.saved-match", kSavedMatchVersion);
  EXPECT_EQ(match_error(), "");
  put_match("cls.saved-match", kSavedMatchVersion + 1);
  EXPECT_EQ(match_error(),
            path() + ": version 2 of saved matches is newer than this cls reads (1); update cls");
  put_match("cls.other", kSavedMatchVersion);
  EXPECT_EQ(match_error(),
            path() + ": not a saved match, or truncated; save one with cls match --save-at");
}

}  // namespace
}  // namespace cls::proto
