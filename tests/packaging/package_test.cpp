// `make package`: what the files need, hold and do, and that they are the same bytes again. Builds
// them twice, so only in the long form (CLS_FULL).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/installed.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class Package : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (std::getenv("CLS_FULL") == nullptr) return;
    folder_ = new TemporaryFolder;
    build("one");
    build("two");
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override {
    if (folder_ == nullptr) GTEST_SKIP() << "takes minutes: CLS_FULL=1";
  }

  static fs::path dist(const std::string& name = "one") { return folder_->path() / name / "dist"; }

  /// The file of the first package whose name matches `pattern`.
  static fs::path file(const std::string& pattern) {
    const std::regex form(pattern);
    for (const auto& entry : fs::directory_iterator(dist())) {
      if (std::regex_match(entry.path().filename().string(), form)) return entry.path();
    }
    ADD_FAILURE() << "no file " << pattern;
    return {};
  }
  static fs::path program() { return file("cls-[0-9.]+-linux-x86_64"); }

  static CommandResult run_there(const Words& words) {
    return Command(words, {}, folder_->path()).finish(std::chrono::seconds(300));
  }

  static inline TemporaryFolder* folder_ = nullptr;

 private:
  static void build(const std::string& name) {
    const CommandResult built = run_there(
        {"python3", source_folder() / "packaging/build.py", CLS_BUILD_DIR, "--out", dist(name)});
    ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  }
};

TEST_F(Package, IsTheSameBytesAgain) {
  const std::string sums = read_file(dist("one") / "SHA256SUMS");
  EXPECT_EQ(sums, read_file(dist("two") / "SHA256SUMS"));
  const CommandResult checked =
      Command({"sha256sum", "-c", "SHA256SUMS"}, {}, dist("two")).finish();
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
  int files = 0;
  for (const auto& entry : fs::directory_iterator(dist())) {
    const std::string name = entry.path().filename().string();
    if (name == "SHA256SUMS") continue;
    EXPECT_THAT(sums, HasSubstr("  " + name + "\n")) << name;
    ++files;
  }
  EXPECT_EQ(files, 4);
}

TEST_F(Package, ProgramNeedsTheCLibraryOnly) {
  const std::string text = run_there({"readelf", "-d", "-V", program()}).out;
  const std::regex needed(R"(\(NEEDED\).*\[([^\]]+)\])");
  std::set<std::string> libraries;
  for (std::sregex_iterator at(text.begin(), text.end(), needed), end; at != end; ++at) {
    libraries.insert((*at)[1]);
  }
  for (const char* part : {"ld-linux-x86-64.so.2", "libm.so.6", "libpthread.so.0", "libdl.so.2"}) {
    libraries.erase(part);
  }
  EXPECT_EQ(libraries, std::set<std::string>{"libc.so.6"});
  const std::regex version(R"(GLIBC_2\.(\d+))");
  for (std::sregex_iterator at(text.begin(), text.end(), version), end; at != end; ++at) {
    EXPECT_LE(std::stoi((*at)[1]), 31) << "docs/install.md states 2.31";
  }
  EXPECT_THAT(text, testing::Not(HasSubstr("GLIBC_ABI_DT_RELR"))) << "glibc 2.36 brought it";
}

TEST_F(Package, ProgramPlaysTheBytesOfTheBuild) {
  std::string logs[2];
  int next = 0;
  for (const fs::path& cls : {program(), cls_binary()}) {
    const std::string dir = "match" + std::to_string(next);
    const CommandResult played = run_there({cls, "match", "mock", "mock:planner", "--seed", "7",
                                            "--cycles", "60", "--dir", dir, "--quiet"});
    ASSERT_EQ(played.exit_code, 0) << played.err;
    logs[next++] = read_file(folder_->path() / dir / "match.rcg");
  }
  EXPECT_EQ(logs[0], logs[1]);
}

// CLS_OLD_ROOT: the files of a system with an old C library, as debootstrap makes them.
TEST_F(Package, ProgramPlaysOnAnOlderCLibrary) {
  const char* root = std::getenv("CLS_OLD_ROOT");
  if (root == nullptr) GTEST_SKIP() << "CLS_OLD_ROOT names no folder";
  const fs::path there = fs::path(root) / "tmp/cls";
  fs::copy_file(program(), there, fs::copy_options::overwrite_existing);
  const std::string match =
      "cd /tmp && ./cls match mock mock:planner --seed 7 --cycles 60 --dir played "
      "--quiet && cat played/match.rcg; rm -rf played cls";
  const CommandResult old = run_there({"chroot", root, "sh", "-c", match});
  const CommandResult here = run_there({cls_binary(), "match", "mock", "mock:planner", "--seed",
                                        "7", "--cycles", "60", "--dir", "here", "--quiet"});
  ASSERT_EQ(old.exit_code, 0) << old.err;
  ASSERT_EQ(here.exit_code, 0) << here.err;
  EXPECT_TRUE(old.out.ends_with(read_file(folder_->path() / "here/match.rcg")));
}

TEST_F(Package, BillOfMaterialsNamesWhatTheProgramLinks) {
  const auto document = nlohmann::json::parse(read_file(file(".*\\.spdx\\.json")));
  EXPECT_EQ(document["spdxVersion"], "SPDX-2.3");
  std::set<std::string> names;
  for (const auto& package : document["packages"]) names.insert(package["name"]);
  for (const char* name : {"cls", "grpc", "openssl", "protobuf", "sqlite3", "sleef", "zlib"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  EXPECT_EQ(document["relationships"].size(), document["packages"].size());
  const std::string sum = document["packages"][0]["checksums"][0]["checksumValue"];
  EXPECT_EQ(run_there({"sha256sum", program()}).out.substr(0, sum.size()), sum);
  if (is_installed("pyspdxtools")) {
    const CommandResult valid = run_there({"pyspdxtools", "-i", file(".*\\.spdx\\.json")});
    EXPECT_EQ(valid.exit_code, 0) << valid.out << valid.err;
  }
}

TEST_F(Package, DebianPackageIsClean) {
  if (!is_installed("lintian")) GTEST_SKIP() << "no lintian";
  const CommandResult lint = run_there(
      {"lintian", "--allow-root", "--fail-on", "error,warning", file("cls_[0-9.]+_amd64\\.deb")});
  EXPECT_EQ(lint.exit_code, 0) << lint.out << lint.err;
  EXPECT_EQ(lint.out, "");
}

}  // namespace
}  // namespace cls::tests
