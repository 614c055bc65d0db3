// `cls doctor` with programs that work, are missing, hang or print garbage, and with servers and
// Playmakers that respond or fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "process/ports.h"
#include "tests/support/built.h"
#include "tests/support/command.h"
#include "tests/support/host_namespaces.h"
#include "tests/support/json.h"
#include "tests/support/marked_processes.h"
#include "tests/support/port_lock.h"
#include "tests/support/rcssserver.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_client.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;
using json = base::Json;
using Arguments = std::vector<std::string>;

/// A PATH with only the programs of the test.
class Doctor : public testing::Test {
 protected:
  Doctor() { std::filesystem::create_directory(path()); }

  std::filesystem::path path() const { return folder_.path() / "bin"; }

  void put(const std::string& name, const std::string& text, const char* first = "#!/bin/sh") {
    const std::filesystem::path file = path() / name;
    std::ofstream(file) << first << "\n" << text << "\n";
    ::chmod(file.c_str(), 0755);
  }

  /// All programs in working order.
  void put_all() {
    put("rcssserver", "echo rcssserver-19.0.0; exit 1");
    put("python3", "echo python 3.11.2; echo grpc 1.51.1; echo google.protobuf 3.21.12");
    put("node", "echo node 20.1.0; echo @grpc/grpc-js 1.9.1; echo @grpc/proto-loader 0.7.2");
    put("protoc", "echo libprotoc 3.21.12");
    put("grpc_python_plugin", "");
    put("sbatch", "echo slurm 22.05.8");
    for (const char* name : {"squeue", "scancel", "scontrol"}) put(name, "");
  }

  Arguments environment() const {
    return {"PATH=" + path().string(), std::string(kMarkVariable) + "=" + mark_};
  }

  static Arguments argv(const Arguments& more) {
    const Arguments all = joined({cls_binary(), "doctor"}, more);
    return all;
  }

  /// Runs it to its end; no process may survive.
  CommandResult run(const Arguments& more) {
    CommandResult result = tests::run(argv(more), environment());
    EXPECT_TRUE(all_marked_gone(mark_));
    return result;
  }

  /// The default limit is long enough for a loaded host.
  json examine(int exit_code, Arguments more = {}, const std::string& limit = "50") {
    more.insert(more.end(), {"--json", "--start-timeout", limit});
    const CommandResult result = run(more);
    EXPECT_EQ(result.exit_code, exit_code) << result.out << result.err;
    EXPECT_EQ(result.err, "");
    const json document = json::parse(result.out);
    EXPECT_EQ(document["schema"], "cls.doctor/1");
    EXPECT_EQ(document["healthy"], exit_code == 0);
    return document;
  }

  static json item(const json& document, const std::string& name) {
    for (const json& each : document["items"]) {
      if (each["name"] == name) return each;
    }
    ADD_FAILURE() << "no item " << name;
    return {};
  }

  static void expect(const json& item, const std::string& status, const std::string& found,
                     const std::string& hint = "") {
    EXPECT_EQ(item.value("status", ""), status) << item;
    EXPECT_THAT(item.value("found", ""), HasSubstr(found)) << item;
    EXPECT_EQ(item["remedy"].is_null(), hint.empty()) << item;
    if (!hint.empty() && item["remedy"].is_string()) {
      EXPECT_THAT(item["remedy"].get<std::string>(), HasSubstr(hint)) << item;
    }
  }

  TemporaryFolder folder_;
  const std::string mark_ = new_mark();
};

const std::vector<std::string> kPrograms = {"rcssserver", "python3", "node", "protoc", "sbatch"};

std::string item_name(const std::string& program) {
  return program == "sbatch" ? "slurm" : program;
}

TEST_F(Doctor, ReportsHost) {
  const json document = examine(0);
  EXPECT_EQ(document["items"][0]["name"], "cls");
  const json own = item(document, "cls");
  EXPECT_EQ(own["path"], cls_binary().string());
  EXPECT_EQ(own["version"], document["version"]);
  const json processors = item(document, "processors");
  const bool busy = processors["remedy"].is_string();
  expect(processors, "ok", " usable of ", busy ? "this host is busy: load " : "");
  expect(item(document, "memory"), "ok", " GB free");
  const bool namespaces = host_has_namespaces();
  expect(item(document, "sandbox"), namespaces ? "ok" : "missing", "namespaces");
  expect(item(document, "folder"), "ok", " GB free");
  expect(item(document, "processes"), "ok", "can be started and stopped");
  for (const char* port : {"UDP port 6000", "UDP port 6001", "UDP port 6002"}) {
    EXPECT_TRUE(item(document, port).contains("status"));
  }
}

TEST_F(Doctor, ReportsMissingProgramsWithInstallCommand) {
  const json document = examine(0);
  expect(item(document, "rcssserver"), "missing", "not on PATH", "apt-get install g++ make");
  expect(item(document, "rcssserver"), "missing", "", "./bootstrap && ./configure && make");
  expect(item(document, "python3"), "missing", "not on PATH",
         "apt-get install python3 python3-grpcio python3-protobuf");
  expect(item(document, "node"), "missing", "not on PATH", "apt-get install nodejs npm");
  expect(item(document, "protoc"), "missing", "not on PATH",
         "apt-get install protobuf-compiler protobuf-compiler-grpc");
  expect(item(document, "slurm"), "missing", "not on PATH", "apt-get install slurm-client");
}

TEST_F(Doctor, ReportsVersionsOfPrograms) {
  put_all();
  const json document = examine(0);
  expect(item(document, "rcssserver"), "ok", "19.0.0");
  expect(item(document, "python3"), "ok", "3.11.2, grpc 1.51.1, google.protobuf 3.21.12, /");
  expect(item(document, "node"), "ok", "20.1.0, @grpc/grpc-js 1.9.1, @grpc/proto-loader 0.7.2, /");
  expect(item(document, "protoc"), "ok", "3.21.12");
  expect(item(document, "slurm"), "ok", "22.05.8");
  EXPECT_EQ(item(document, "node")["version"], "20.1.0");

  expect(item(document, "python3"), "ok",
         "; cls_playmaker missing: ./bootstrap python in the checkout");
  put("python3",
      "echo python 3.11.2; echo grpc 1.51.1; echo google.protobuf 3.21.12; "
      "echo cls_playmaker installed");

  const std::string found = item(examine(0), "python3")["found"].get<std::string>();
  EXPECT_THAT(found, Not(HasSubstr("cls_playmaker")));
  EXPECT_EQ(item(document, "python3")["path"], (path() / "python3").string());
}

TEST_F(Doctor, ReportsMissingPackages) {
  put_all();
  put("python3",
      "echo python 3.12.1; echo grpc broken: TypeError too new; echo google.protobuf 4.25");
  put("node", "echo node 20.1.0; echo @grpc/grpc-js missing");
  std::filesystem::remove(path() / "grpc_python_plugin");
  std::filesystem::remove(path() / "scontrol");
  const json document = examine(0);
  expect(item(document, "python3"), "missing", "grpc broken: TypeError too new",
         (path() / "python3").string() + " -m pip install grpcio protobuf");
  expect(item(document, "node"), "missing", "@grpc/grpc-js missing", "npm install @grpc/grpc-js");
  expect(item(document, "node"), "missing", "@grpc/proto-loader missing", "apt-get install npm");
  expect(item(document, "protoc"), "missing", "grpc_python_plugin missing",
         "apt-get install protobuf-compiler");
  expect(item(document, "slurm"), "missing", "scontrol missing", "apt-get install slurm-client");
}

TEST_F(Doctor, ReportsUntestedServerVersion) {
  put("rcssserver", "echo rcssserver-15.3.0");
  expect(item(examine(0), "rcssserver"), "ok", "15.3.0, /");
  expect(item(examine(0), "rcssserver"), "ok", "cls is tested with rcssserver 19");
}

TEST_F(Doctor, ReportsServerWithMissingLibraries) {
  put("rcssserver",
      "echo 'rcssserver: error while loading shared libraries: x.so: not found' >&2; exit 127");
  expect(item(examine(0), "rcssserver"), "wrong", "error while loading shared libraries",
         "ldconfig");
}

TEST_F(Doctor, ReportsSlurmWithoutCluster) {
  put_all();
  put("sbatch", "echo 'sbatch: fatal: Could not establish a configuration source' >&2; exit 1");
  expect(item(examine(0), "slurm"), "unreachable", "fatal: Could not establish a configuration",
         "SLURM_CONF");
}

TEST_F(Doctor, TerminatesHangingProgramsAfterTimeout) {
  for (const std::string& name : kPrograms) {
    put(name, "trap '' TERM\nexec " + built("cls_fake_process") + " stubborn-grandchild hang");
  }
  put("node", "while :; do echo flood; done");
  const auto begin = std::chrono::steady_clock::now();
  const json document = examine(0, {}, "0.5");
  // In sequence, or without a timeout, they would take far longer.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 30s);
  for (const std::string& name : kPrograms) {
    expect(item(document, item_name(name)), "wrong", "timeout", " ");
  }
}

TEST_F(Doctor, QuotesUnexpectedOutput) {
  put_all();
  for (const std::string& name : kPrograms) put(name, "printf '\\033[31m\\377rub\\001bish\\n'");
  const json document = examine(0);
  for (const std::string& name : kPrograms) {
    expect(item(document, item_name(name)), "wrong", "prints '?[31m?rub?bish', exit code 0", " ");
  }
}

TEST_F(Doctor, ReportsCrashedAndUnstartablePrograms) {
  put("rcssserver", "kill -SEGV $$");
  put("python3", "exit 3");
  put("node", "", "#!/no/such/interpreter");
  const json document = examine(0);
  expect(item(document, "rcssserver"), "wrong", "prints nothing, killed by SIGSEGV", " ");
  expect(item(document, "python3"), "wrong", "prints nothing, exit code 3", " ");
  expect(item(document, "node"), "wrong", "/node", " ");
}

TEST_F(Doctor, PrintsTable) {
  put("python3", "echo python 3.11.2; echo grpc 1.51.1; echo google.protobuf 3.21.12");
  const CommandResult result = run({"--start-timeout", "50"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* line :
       {"ok           python3        3.11.2, grpc 1.51.1", "\nmissing      node ",
        "needed for: Playmakers in JavaScript\n", "hint: ", "apt-get install nodejs npm",
        "\nReady to play: cls match mock mock\n"}) {
    EXPECT_THAT(result.out, HasSubstr(line)) << line << " in\n";
  }
  EXPECT_EQ(result.out.find('\x1b'), std::string::npos) << "no color in a file";
}

TEST_F(Doctor, PrintsHelpWithExamplesFirst) {
  const CommandResult help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_LT(help.out.find("cls doctor --playmaker localhost:50051"), help.out.find("Usage: "));
}

TEST_F(Doctor, ReportsOwnerOfPortInUse) {
  const PortLock lock;
  Command owner({built("cls_fake_process"), "bind-udp", "6001", "print", "bound", "hang"});
  if (!owner.wait_for_output("bound")) GTEST_SKIP() << "port 6001 is in use by another process";
  expect(item(examine(0), "UDP port 6001"), "taken",
         "is taken by cls_fake_proces (process " + std::to_string(owner.pid()) + ")",
         "stop that process");
}

TEST_F(Doctor, LeavesNoProcessAfterSignal) {
  for (const std::string& name : kPrograms) put(name, "echo $$ > $0.pid; exec /bin/sleep 1000");
  Command command(argv({"--start-timeout", "50"}), environment());
  const auto begin = std::chrono::steady_clock::now();
  const auto asked = [&] { return std::filesystem::exists(path() / "sbatch.pid"); };
  while (!asked() && std::chrono::steady_clock::now() - begin < 40s) {
    std::this_thread::sleep_for(5ms);
  }
  ASSERT_TRUE(asked());
  command.send_signal(SIGINT);
  EXPECT_EQ(command.finish().exit_code, 130);
  EXPECT_TRUE(all_marked_gone(mark_));
}

using DoctorServer = Doctor;

/// A server program with these flags.
std::string with_flags(const std::string& flags) {
  return "exec " + built("cls_fake_server") + " " + flags + " \"$@\"";
}

TEST_F(DoctorServer, StartsAndResponds) {
  put("rcssserver", with_flags(""));
  const json server = item(examine(0, {"--server", "rcssserver"}), "server");
  expect(server, "ok",
         "19.0.0, " + (path() / "rcssserver").string() + ": starts, synchronous mode");
  expect(server, "ok", "before_kick_off, cycle 0, no teams");
  EXPECT_EQ(server["needed"], true);
}

TEST_F(DoctorServer, AcceptsEmbeddedServer) {
  expect(item(examine(0, {"--server", "embedded"}), "server"), "ok", "starts, synchronous mode");
}

TEST_F(DoctorServer, AcceptsRcssserver) {
  const std::string program = rcssserver_program();
  if (program.empty()) GTEST_SKIP() << "no rcssserver on PATH nor in CLS_RCSSSERVER";
  const std::string conf = folder_.path() / "home";
  CommandResult result =
      tests::run(argv({"--json", "--server", program, "--start-timeout", "50"}), {"HOME=" + conf});
  EXPECT_EQ(result.exit_code, 0) << result.out;
  expect(item(json::parse(result.out), "server"), "ok", "before_kick_off, cycle 0, no team");
  EXPECT_FALSE(std::filesystem::exists(conf)) << "the user's configuration is not touched";
}

TEST_F(DoctorServer, ReportsEachFaultAndLeavesNoProcess) {
  struct Case {
    std::string flags;
    std::string found;
    std::string limit;
  };

  const std::vector<Case> cases = {
      {"--exit-at-start 1", "exited at start: exit code 1 (Error: the stadium is closed)", "50"},
      {"--never-open 1 --ignore-term 1", "did not open UDP port ", "0.5"},
      {"--port-offset 1", "did not open UDP port ", "0.5"},
      {"--silent 1 --grandchild 1", " within 0.5 s", "0.5"},
  };

  for (const Case& each : cases) {
    put("server", with_flags(each.flags));
    const std::string program = path() / "server";
    const json document = examine(69, {"--server", program}, each.limit);
    expect(item(document, "server"), "unreachable", each.found, "start it by hand");
  }
}

TEST_F(DoctorServer, ReportsNonexecutablePrograms) {
  put("server", "");
  ::chmod((path() / "server").c_str(), 0644);
  const auto found = [&](const std::string& server) {
    return item(examine(69, {"--server", server}), "server")["found"].get<std::string>();
  };
  EXPECT_THAT(found(path() / "server"), HasSubstr(" is not executable"));
  EXPECT_THAT(found(path()), HasSubstr(" is a folder"));
  EXPECT_THAT(found("rcssserver"), HasSubstr("no such program on PATH"));
}

TEST_F(DoctorServer, ProbesRunningServerWithoutConnectingAPlayer) {
  Command running({cls_binary(), "server", "--port", "0", "--dir", folder_.path(),
                   "server::synch_mode=off", "server::half_time=77"});
  ASSERT_TRUE(running.wait_for_output("Hit CTRL-C"));
  const std::string line = running.out().substr(0, running.out().find('\n'));
  const std::size_t colon = line.find(':') + 1;
  const std::string port = line.substr(colon, line.find(',') - colon);
  for (int i = 0; i < 2; ++i) {
    const json server = item(examine(0, {"--server", "127.0.0.1:" + port}), "server");
    expect(server, "ok", "real time, 100 ms per cycle, halves of 77 s; before_kick_off, cycle 0");
    expect(server, "ok", "no teams");
  }
}

TEST_F(DoctorServer, ReportsUnreachableAddress) {
  expect(item(examine(69, {"--server", "127.0.0.1:9"}), "server"), "unreachable",
         "127.0.0.1:9: no listener at this UDP port", "start it");
  expect(item(examine(69, {"--server", "no.such.host.invalid:6000"}), "server"), "unreachable",
         "no.such.host.invalid", "start it");
}

TEST_F(DoctorServer, TimesOutOnPortWithoutReply) {
  UdpClient silent(9);
  const std::string address = "127.0.0.1:" + std::to_string(silent.own_port());
  expect(item(examine(69, {"--server", address}, "0.3"), "server"), "unreachable",
         "no reply within 0.3 s", "start it");
}

TEST_F(DoctorServer, QuotesReplyOfAnotherProtocol) {
  UdpClient stranger(9);
  std::atomic<bool> over{false};
  // The reply must use the addresses of the request.
  std::thread answers([&] {
    while (!over) {
      if (!stranger.wait_bytes(50ms).empty()) stranger.send_bytes("HTTP/1.1 400 Bad Request");
    }
  });
  const std::string address = "127.0.0.1:" + std::to_string(stranger.own_port());
  const json document = examine(1, {"--server", address});
  over = true;
  answers.join();
  expect(item(document, "server"), "wrong", "replies 'HTTP/1.1 400 Bad Request'", "this port");
}

using DoctorPlaymaker = Doctor;

/// Address of a mock with these flags.
std::string address_of(Command& mock) {
  if (!mock.wait_for_output("\n")) return "no mock";
  const std::string line = mock.out();
  return line.substr(13, line.find('\n') - 13);
}

TEST_F(DoctorPlaymaker, RespondsAndDecides) {
  Command mock({cls_binary(), "mock"});
  const json playmaker = item(examine(0, {"--playmaker", address_of(mock)}), "playmaker");
  expect(playmaker, "ok", "Register replied after ");
  expect(playmaker, "ok", "; implements GetBestPlannerAction");
  // It still serves other clients: no agent sent bye.
  expect(item(examine(0, {"--playmaker", address_of(mock)}), "playmaker"), "ok", "Register");
}

TEST_F(DoctorPlaymaker, ReportsUnimplementedPlanner) {
  Command mock({cls_binary(), "mock", "--unimplemented", "GetBestPlannerAction"});
  expect(item(examine(0, {"--playmaker", address_of(mock)}), "playmaker"), "ok",
         "does not implement GetBestPlannerAction");
}

TEST_F(DoctorPlaymaker, StartsRunSide) {
  const std::string command = "run:exec " + built("cls_fake_playmaker") + " --port {port}";
  expect(item(examine(0, {"--playmaker", command}), "playmaker"), "ok", "Register replied");
}

TEST_F(DoctorPlaymaker, ReportsFailedCallOfHandshake) {
  Command mock({cls_binary(), "mock", "--unimplemented", "SendPlayerType"});
  expect(item(examine(1, {"--playmaker", address_of(mock)}), "playmaker"), "wrong",
         ": all_parameters: ", "cls check playmaker ");
}

TEST_F(DoctorPlaymaker, ReportsUnreachableAddress) {
  const auto ports = cls::process::ReservedPort::choose(1);
  const std::string address = "127.0.0.1:" + std::to_string((*ports)[0].number());
  expect(item(examine(69, {"--playmaker", address}), "playmaker"), "unreachable",
         address + ": connection refused", "start it first");
  expect(item(examine(69, {"--playmaker", "unix:/no/such/socket"}), "playmaker"), "unreachable",
         "/no/such/socket: no such file", "start it first");
  expect(item(examine(69, {"--playmaker", "unix:" + path().string()}), "playmaker"), "unreachable",
         ": not a socket", "start it first");
}

TEST_F(DoctorPlaymaker, TimesOutWithoutReply) {
  const auto ports = cls::process::ReservedPort::choose(1);
  const std::string port = std::to_string((*ports)[0].number());
  Command silent({built("cls_fake_process"), "listen-tcp", port, "print", "bound", "hang"});
  ASSERT_TRUE(silent.wait_for_output("bound"));
  expect(item(examine(69, {"--playmaker", "127.0.0.1:" + port}, "0.5"), "playmaker"), "unreachable",
         "127.0.0.1:" + port + " accepts connections and sends nothing", "start it first");
}

TEST_F(DoctorPlaymaker, ReportsExitAtStart) {
  const std::string command =
      "run:exec " + built("cls_fake_playmaker") + " --port {port} --exit-at-start 5";
  expect(item(examine(69, {"--playmaker", command}, "2"), "playmaker"), "unreachable",
         "run:", "start it first");
}

TEST_F(Doctor, ReportsUsageErrors) {
  const std::vector<std::pair<Arguments, std::string>> cases = {
      {{"--server", "rcssserer"}, "did you mean 'rcssserver'?"},
      {{"--server", "host:99999"}, "HOST:PORT with a port from 1 to 65535"},
      {{"--playmaker", "team:x"}, "team:DIR has no Playmaker"},
      {{"--playmaker", "nonsense"}, "nonsense"},
      {{"--playmakr", "x"}, "did you mean '--playmaker'?"},
      {{"--start-timeout", "-1"}, "--start-timeout"},
      {{"now"}, "now"},
  };
  for (const auto& [more, message] : cases) {
    const CommandResult result = run(more);
    EXPECT_EQ(result.exit_code, 2) << message;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  }
}

}  // namespace
}  // namespace cls::tests
