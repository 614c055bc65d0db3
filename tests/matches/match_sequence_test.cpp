// A sequence of matches leaves no process, port, file, descriptor, thread or memory behind.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "process/ports.h"
#include "tests/matches/full_tests.h"
#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using cls::tests::built;

void write_script(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "#!/bin/sh\n" << text << "\n";
  ::chmod(file.c_str(), 0755);
}

/// Resources of the process after one match.
struct Holding {
  long kilobytes = 0;
  long descriptors = 0;
  long threads = 0;
};

std::vector<Holding> holdings_in(const std::string& output) {
  std::vector<Holding> holdings;
  std::istringstream lines(output);
  for (Holding now; lines >> now.kilobytes >> now.descriptors >> now.threads;)
    holdings.push_back(now);
  return holdings;
}

/// The number after `name` in each line of `text`; `usual` where a server gets no such word.
std::vector<int> numbers_behind(const std::string& name, int usual, const std::string& text) {
  std::vector<int> numbers;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(name);
    numbers.push_back(at == std::string::npos ? usual : std::stoi(line.substr(at + name.size())));
  }
  return numbers;
}

class MatchSequence : public testing::Test {
 protected:
  // A team of 11 that never exits, and a server that records its ports.
  void SetUp() override {
    write_script(path() / "team/start.sh",
                 cls::tests::export_mark(mark_) +
                     "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; -t) name=$2;; esac; shift 2; "
                     "done\nfor i in $(seq 11); do " +
                     cls::tests::copy_built("cls_fake_player", path() / "team") +
                     " --port $port --name $name & sleep 0.01; done");
    write_script(path() / "server", "echo \"$*\" >> " + (path() / "words").string() + "\nexec " +
                                        built("cls_fake_server") + " \"$@\"");
    fs::create_directories(path() / "tmp");
  }

  cls::tests::CommandResult play(int count) {
    cls::tests::Command row(
        {built("cls_match_sequence"), path() / "matches",
         "run:exec " + built("cls_fake_playmaker") + " --port {port}",
         "team:" + (path() / "team").string(), path() / "server", std::to_string(count)},
        {std::string(cls::tests::kMarkVariable) + "=" + mark_,
         "TMPDIR=" + (path() / "tmp").string()});
    return row.finish(std::chrono::seconds(3000));
  }

  fs::path path() const { return folder_.path(); }

  cls::tests::TemporaryFolder folder_;
  const std::string mark_ = cls::tests::new_mark();
};

TEST_F(MatchSequence, LeavesNoResources) {
  const int count = cls::tests::full_tests_requested() ? 200 : 10;
  const auto played = play(count);
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_TRUE(cls::tests::marked_processes(mark_).empty());
  EXPECT_TRUE(fs::is_empty(path() / "tmp"));
  EXPECT_TRUE(fs::is_empty(path() / "matches"));

  const std::string words = cls::tests::read_file(path() / "words");
  for (const auto& [name, usual] :
       {std::pair{"server::port=", 6000}, std::pair{"server::coach_port=", 6001},
        std::pair{"server::olcoach_port=", 6002}}) {
    const std::vector<int> ports = numbers_behind(name, usual, words);
    EXPECT_EQ(ports.size(), static_cast<std::size_t>(count / 2));
    for (const int port : ports) {
      EXPECT_TRUE(cls::process::port_is_free(cls::process::Protocol::kUdp, port)) << port;
    }
  }

  const std::vector<Holding> holdings = holdings_in(played.out);
  ASSERT_EQ(holdings.size(), static_cast<std::size_t>(count));

  // Libraries fill caches and start threads in the first matches of each kind.
  const std::size_t settled = holdings.size() / 5;
  const auto compare = [&](long Holding::*what) {
    const auto less = [what](const Holding& a, const Holding& b) { return a.*what < b.*what; };
    const auto middle = holdings.begin() + static_cast<std::ptrdiff_t>(settled);
    const Holding most = *std::max_element(holdings.begin(), middle, less);
    return std::pair(most.*what, holdings.back().*what);
  };
  // One team of agents uses more than this; any relevant leak exceeds it.
  constexpr long kKilobytesAMatch = 10;
  const auto [memory_early, memory_late] = compare(&Holding::kilobytes);
  EXPECT_LT(memory_late - memory_early, kKilobytesAMatch * (count - static_cast<long>(settled)));

  const auto [files_early, files_late] = compare(&Holding::descriptors);
  EXPECT_LE(files_late, files_early);

  const auto [threads_early, threads_late] = compare(&Holding::threads);
  EXPECT_LE(threads_late, threads_early + 2);

  std::cout << count << " matches: " << memory_early << " KB in use early, " << memory_late
            << " KB at the end; descriptors " << files_early << ", " << files_late << "; threads "
            << threads_early << ", " << threads_late << "\n";
}

}  // namespace
