// Matches over UDP with external servers and teams, whose processes are found again.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/port_lock.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {

/// A match whose processes carry a mark in their environment, to find survivors.
class NetworkMatch : public testing::Test {
 protected:
  std::string script(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "#!/bin/sh\n" << export_mark(mark_) << text << "\n";
    ::chmod(file.c_str(), 0755);
    return file;
  }

  /// A server program with these flags.
  std::string server(const std::string& flags) {
    return script("server", "exec " + built("cls_fake_server") + " " + flags + " \"$@\"");
  }

  /// The program of the team's agents.
  std::string player() const { return copy_built("cls_fake_player", folder_.path() / "team"); }

  /// A team folder with a start.sh that starts up to 11 players and returns.
  std::string team(const std::string& flags, int players = 11) {
    script(
        "team/start.sh",
        "while [ $# -gt 0 ]; do case $1 in -p) port=$2;; -t) name=$2;; -C) shift; continue;; esac; "
        "shift 2; done\n"
        "for i in $(seq " +
            std::to_string(players) +
            "); do\n"
            "  goalie=; [ $i = 1 ] && goalie='--goalie 1'\n" +
            player() + " --port $port --name $name $goalie " + flags + " &\n  sleep 0.02\ndone");
    return "team:" + (folder_.path() / "team").string();
  }

  /// A team folder whose `start` runs player 7 with `flags`; agent 12 only waits.
  std::string team_of_single_agents(const std::string& flags) {
    script("team/start",
           "[ $3 = 12 ] && exec sleep 1000\n[ $3 = 1 ] && more='--goalie 1'\n"
           "[ $3 = 7 ] && more='" +
               flags + "'\nexec " + player() + " --name Guests $more");
    return "team:" + (folder_.path() / "team").string();
  }

  std::vector<std::string> arguments(const std::string& right, const std::string& server,
                                     const std::vector<std::string>& more,
                                     const std::vector<std::string>& settings = {
                                         "--set", "server::kick_off_wait=3"}) const {
    std::vector<std::string> argv = launcher_;
    const std::vector<std::string> match = {cls_binary(), "match",    left_,   right,
                                            "--seed",     "7",        "--dir", match_folder(),
                                            "--force",    "--server", server};
    argv.insert(argv.end(), match.begin(), match.end());
    argv.insert(argv.end(), settings.begin(), settings.end());
    argv.insert(argv.end(), more.begin(), more.end());
    return argv;
  }
  std::string match_folder() const { return folder_.path() / "match"; }
  std::vector<std::string> environment() const {
    return {std::string(kMarkVariable) + "=" + mark_};
  }

  /// Plays; no process may survive the return of cls. External teams take the usual ports of a
  /// server if they are free, which other tests need.
  void play(const std::string& right, const std::string& server,
            const std::vector<std::string>& more = {},
            const std::vector<std::string>& settings = {"--set", "server::kick_off_wait=3"}) {
    const PortLock ports;
    const auto begin = std::chrono::steady_clock::now();
    played_ = run(arguments(right, server, more, settings), environment());
    took_ = std::chrono::steady_clock::now() - begin;
    EXPECT_TRUE(all_marked_gone(mark_));
    const std::string file = match_folder() + "/result.json";
    if (std::filesystem::exists(file)) result_ = base::Json::parse(read_file(file));
  }

  void expect_finished() const {
    EXPECT_EQ(played_.exit_code, 0) << played_.err;
    EXPECT_EQ(result_.value("end_reason", ""), "finished");
  }

  void expect_end(const std::string& reason, int exit_code, const std::string& message) const {
    EXPECT_EQ(result_.value("end_reason", ""), reason) << played_.err;
    EXPECT_EQ(played_.exit_code, exit_code);
    EXPECT_NE(played_.err.find(message), std::string::npos) << played_.err;
    EXPECT_TRUE(result_["winner"].is_null());
  }

  void expect_failed(const std::string& process, const std::string& last_output_line) const {
    const base::Json& failure = result_["failure"];
    ASSERT_TRUE(failure.is_object()) << played_.err;
    EXPECT_EQ(failure["process"], process);
    const std::string output = failure["output"].dump();
    EXPECT_NE(output.find(last_output_line), std::string::npos) << output;
    EXPECT_NE(played_.err.find("  " + process + ": "), std::string::npos) << played_.err;
  }

  TemporaryFolder folder_;
  const std::string mark_ = new_mark();
  std::vector<std::string> launcher_;  ///< a program that runs cls
  std::string left_ = "mock:hold";
  CommandResult played_;
  base::Json result_;
  std::chrono::steady_clock::duration took_{};
};

}  // namespace cls::tests
