// Plans as shell commands, encoding, and the search for programs.
#include "process/command_plan.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "process/packet.h"
#include "process/process_exit.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;

TEST(CommandPlan, QuotesSpecialCharacters) {
  EXPECT_EQ(shell_quoted("server::port=6000"), "server::port=6000");
  EXPECT_EQ(shell_quoted("two words"), "'two words'");
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_quoted("$HOME"), "'$HOME'");
  EXPECT_EQ(shell_quoted("~"), "'~'");
  EXPECT_EQ(shell_quoted("*"), "'*'");
}

TEST(CommandPlan, FormatsEquivalentShellCommand) {
  CommandPlan plan;
  plan.argv = {"/opt/my team/start", "localhost", "1"};
  EXPECT_EQ(to_shell(plan), "'/opt/my team/start' localhost 1");

  plan.folder = "/opt/my team";
  plan.environment = {{"LANG", "C"}, {"DISPLAY", std::nullopt}};
  plan.cpus = {0, 2};
  EXPECT_EQ(to_shell(plan),
            "cd '/opt/my team' && env -u DISPLAY LANG=C taskset -c 0,2 '/opt/my team/start' "
            "localhost 1");
  EXPECT_EQ(to_shell(shell_command("x", "sleep 1; echo done")), "/bin/sh -c 'sleep 1; echo done'");

  plan = shell_command("x", "true");
  plan.folder = "/opt";
  plan.empty_environment = true;
  EXPECT_EQ(to_shell(plan), "cd /opt && env -i /bin/sh -c true");
  plan.empty_environment = false;
  plan.limits = {64 << 20, 9};
  EXPECT_EQ(to_shell(plan), "(ulimit -d 65536; ulimit -t 9; cd /opt && /bin/sh -c true)");
}

TEST(CommandPlan, DecodesWhatWasEncoded) {
  CommandPlan plan;
  plan.name = "right coach";
  plan.argv = {"a", "", "c d", "\xff\n"};
  plan.folder = "/tmp";
  plan.environment = {{"A", "1=2"}, {"B", ""}, {"C", std::nullopt}};
  plan.cpus = {3, 5};
  plan.limits = {5ULL << 30, 7};
  plan.connections_trapped = true;
  plan.empty_environment = true;
  plan.files = {{"/usr", "/bin"}, {"/tmp/a b"}};
  const auto decoded = decode_plan(encode(plan));

  ASSERT_TRUE(decoded);
  EXPECT_EQ(*decoded, plan);

  plan.files.reset();
  EXPECT_EQ(decode_plan(encode(plan)), plan);
  EXPECT_FALSE(decode_plan("rubbish"));
  EXPECT_FALSE(decode_plan(encode(CommandPlan{})));
}

TEST(CommandPlan, FindsProgramsAndReportsWhyNot) {
  EXPECT_EQ(find_program("sh")->filename(), "sh");
  EXPECT_EQ(find_program("rcssserver-from-nowhere").error().message,
            "rcssserver-from-nowhere: no such program on PATH");

  const tests::TemporaryFolder folder;
  const fs::path file = folder.path() / "start";
  EXPECT_EQ(find_program(file).error().message, file.string() + ": no such file");

  std::ofstream(file) << "#!/bin/sh\n";
  EXPECT_EQ(find_program(file).error().message, file.string() + " is not executable");
  ::chmod(file.c_str(), 0755);
  EXPECT_EQ(*find_program(file), file);
  EXPECT_EQ(find_program(folder.path()).error().message,
            folder.path().string() + " is a folder, not a program");
  EXPECT_EQ(find_program("").error().message, "no program to start");
}

std::string error_of(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  const auto found = find_program(file);
  if (found) return "";
  const std::string start = file.string() + " cannot be started: ";
  EXPECT_EQ(found.error().message.substr(0, start.size()), start);
  return found.error().message.substr(start.size());
}

// The kernel says "No such file or directory" of the program itself.
TEST(FindProgram, NamesAMissingInterpreterOrLoader) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "start.sh";
  EXPECT_EQ(error_of(file, "#!/bin/sh\n"), "");
  EXPECT_EQ(error_of(file, "echo without a first line\n"), "");
  EXPECT_EQ(error_of(file, "#!"), "");
  EXPECT_EQ(error_of(file, "#! /opt/no/python3 -u\nx"),
            "its interpreter /opt/no/python3 does not exist");

  for (const char* script : {"#!/bin/sh\r\necho\r\n", "#!/usr/bin/env bash\r\n", "echo a\r\n"}) {
    EXPECT_EQ(error_of(file, script).substr(0, 45), "its first line ends with a carriage return; w")
        << script;
  }
  std::string program = tests::read_file("/proc/self/exe");
  EXPECT_EQ(error_of(file, program), "");

  const std::string loader = "/lib64/ld-linux";
  const std::size_t at = program.find(loader);
  ASSERT_NE(at, std::string::npos);
  program.replace(at, 6, "/lib63");
  EXPECT_EQ(error_of(file, program), "its loader /lib63/ld-linux-x86-64.so.2 does not exist");
  EXPECT_EQ(error_of(file, program.substr(0, 100)), "") << "cut";
}

TEST(ProcessExit, FormatsExitCodeOrSignalName) {
  EXPECT_EQ(to_text(ProcessExit{false, 3}), "exit code 3");
  EXPECT_EQ(to_text(ProcessExit{true, SIGSEGV}), "killed by SIGSEGV");
  EXPECT_EQ(to_text(ProcessExit{false, 139}), "exit code 139 (128 + SIGSEGV)");
  EXPECT_EQ(to_text(ProcessExit{false, 255}), "exit code 255");
  EXPECT_EQ(signal_name(SIGTERM), "SIGTERM");
  EXPECT_EQ(signal_name(500), "signal 500");
}

}  // namespace
}  // namespace cls::process
