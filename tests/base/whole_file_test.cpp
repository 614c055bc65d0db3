// Atomic and durable writes of small files.
#include "base/io/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/io/replacement.h"

#include "tests/support/temporary_folder.h"

namespace {

struct Sync {
  bool folder = false;
  off_t size = 0;
  bool renamed = false;  ///< the target existed
};
std::vector<Sync> syncs;
std::string target;

}  // namespace

// Replaces the function of the C library in this program.
extern "C" int fsync(int fd) {
  struct stat file {};
  struct stat renamed {};
  ::fstat(fd, &file);
  syncs.push_back({S_ISDIR(file.st_mode), file.st_size, ::stat(target.c_str(), &renamed) == 0});
  return static_cast<int>(::syscall(SYS_fsync, fd));
}

namespace cls::base {
namespace {

TEST(WriteFileDurably, SyncsTheContentBeforeTheRenameAndTheNameAfterIt) {
  tests::TemporaryFolder folder;
  target = folder.path() / "plan.toml";
  syncs.clear();

  ASSERT_TRUE(write_file_durably(target, "seed = 7\n"));
  ASSERT_EQ(syncs.size(), 2u);
  EXPECT_FALSE(syncs[0].folder);
  EXPECT_EQ(syncs[0].size, 9);
  EXPECT_FALSE(syncs[0].renamed);
  EXPECT_TRUE(syncs[1].folder);
  EXPECT_TRUE(syncs[1].renamed);
  EXPECT_EQ(read_file(target), "seed = 7\n");
}

TEST(WriteFile, ReplacesAFileAtomicallyWithoutSync) {
  tests::TemporaryFolder folder;
  target = folder.path() / "page.html";
  syncs.clear();
  ASSERT_TRUE(write_file(target, "old"));
  ASSERT_TRUE(write_file(target, "new"));
  EXPECT_TRUE(syncs.empty());
  EXPECT_EQ(read_file(target), "new");
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// Files of this process cannot grow beyond `bytes` while it exists.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(WriteFile, LeavesTheOldFileAndNoTemporaryOneWhenTheDiskIsFull) {
  tests::TemporaryFolder folder;
  target = folder.path() / "result.json";
  ASSERT_TRUE(write_file(target, "old"));

  Result<void> written;
  {
    const FileSizeLimit limit(100);
    written = write_file(target, std::string(1000, 'x'));
  }

  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "cannot write '" + target + "': File too large");
  EXPECT_EQ(read_file(target), "old");
  EXPECT_THAT(names_in(folder.path()), testing::ElementsAre("result.json"));
}

TEST(WriteFile, LeavesNoTemporaryFileBesideAFolderOfThatName) {
  tests::TemporaryFolder folder;
  target = folder.path() / "result.json";
  std::filesystem::create_directory(target);
  EXPECT_FALSE(write_file(target, "new"));
  EXPECT_THAT(names_in(folder.path()), testing::ElementsAre("result.json"));
}

TEST(WriteFile, WritesIntoDevicesPipesAndLinks) {
  tests::TemporaryFolder folder;
  const auto written = write_file("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "cannot write '/dev/full': No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_TRUE(write_file_durably("/dev/null", "x"));

  const std::string fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::optional<std::string> received;
  std::thread reader([&] { received = read_file(fifo); });
  EXPECT_TRUE(write_file_durably(fifo, "through a pipe"));
  reader.join();
  EXPECT_EQ(received, "through a pipe");
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));

  const std::string link = folder.path() / "link";
  std::filesystem::create_symlink("real.txt", link);
  EXPECT_TRUE(write_file(link, "through a link"));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_file(folder.path() / "real.txt"), "through a link");
}

// Another user of a shared folder guesses the name of the temporary file.
TEST(WriteFile, FollowsNoLinkThatIsPlantedBesideTheFile) {
  tests::TemporaryFolder folder;
  const std::filesystem::path victim = folder.path() / "victim";
  ASSERT_TRUE(write_file(victim, "precious"));

  std::set<std::string> seen;
  for (int i = 0; i < 3; ++i) {
    auto replacement = Replacement::start(folder.path() / "rep.csv");
    ASSERT_TRUE(replacement);
    EXPECT_EQ(replacement->place().extension(), ".csv");
    seen.insert(replacement->place().string());
  }
  EXPECT_EQ(seen.size(), 3u);

  std::filesystem::create_symlink(victim, folder.path() / "rep.csv.tmp");
  ASSERT_TRUE(write_file(folder.path() / "rep.csv", "table"));
  EXPECT_EQ(read_file(victim), "precious");
}

TEST(RemoveAbandoned, RemovesWhatAKilledProcessLeftAndNothingElse) {
  tests::TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder.path() / "result.json", "whole"));

  auto alive = Replacement::start(folder.path() / "alive.json");
  ASSERT_TRUE(alive);

  const pid_t killed = ::fork();
  ASSERT_GE(killed, 0);
  if (killed == 0) {
    const auto left = Replacement::start(folder.path() / "left.json");
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_EQ(::waitpid(killed, nullptr, 0), killed);
  EXPECT_EQ(names_in(folder.path()).size(), 3u);
  remove_abandoned(folder.path());
  EXPECT_THAT(names_in(folder.path()),
              testing::UnorderedElementsAre("result.json", alive->place().filename().string()));
  EXPECT_TRUE(alive->finish());
  EXPECT_THAT(names_in(folder.path()), testing::UnorderedElementsAre("result.json", "alive.json"));
}

TEST(ReadText, SkipsAByteOrderMark) {
  tests::TemporaryFolder folder;
  const std::string file = folder.path() / "server.conf";
  ASSERT_TRUE(write_file(file, "\xef\xbb\xbfserver::half_time = 7\n"));
  EXPECT_EQ(read_text(file), "server::half_time = 7\n");
  EXPECT_EQ(read_file(file), "\xef\xbb\xbfserver::half_time = 7\n");
  EXPECT_EQ(read_text(folder.path() / "missing"), std::nullopt);
}

TEST(WriteFile, LetsParallelWritersReplaceAFile) {
  tests::TemporaryFolder folder;
  const std::string file = folder.path() / "report.html";
  std::atomic<int> failed{0};
  std::vector<std::thread> writers;

  for (char letter : {'a', 'b', 'c', 'd'}) {
    writers.emplace_back([&, letter] {
      for (int i = 0; i < 200; ++i) failed += !write_file(file, std::string(5000, letter));
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(failed, 0);

  const std::string last = read_file(file).value_or("");
  EXPECT_EQ(last, std::string(5000, last.empty() ? '?' : last.front()));
  EXPECT_THAT(names_in(folder.path()), testing::ElementsAre("report.html"));
}

}  // namespace
}  // namespace cls::base
