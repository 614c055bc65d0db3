// Version commands of programs and the evaluation of their output.
#include "checks/doctor/program_checks.h"

#include <fmt/format.h>

#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "match/programs/server_plan.h"

namespace cls::checks {
namespace {

constexpr std::string_view kTestedServer = "19.";

constexpr const char* kServerBuild =
    "g++ make autoconf automake libtool flex bison zlib1g-dev libboost-system-dev";

// Lines "NAME VERSION", "NAME missing", or "NAME broken: WHY".
constexpr const char* kPythonScript = R"(
import importlib, sys
print("python", sys.version.split()[0])
for name in ("grpc", "google.protobuf"):
    try:
        print(name, importlib.import_module(name).__version__)
    except ModuleNotFoundError:
        print(name, "missing")
    except Exception as error:
        print(name, "broken:", type(error).__name__, error)
try:
    importlib.import_module("cls_playmaker")
    print("cls_playmaker installed")
except Exception as error:
    print("cls_playmaker missing")
)";

constexpr const char* kNodeScript = R"(
console.log("node", process.versions.node);
for (const name of ["@grpc/grpc-js", "@grpc/proto-loader"]) {
  try {
    console.log(name, require(name + "/package.json").version);
  } catch (error) {
    console.log(name, error.code === "MODULE_NOT_FOUND" ? "missing" : "broken: " + error.code);
  }
}
)";

// The text after "NAME " in the first line that starts with it; empty without one.
std::string text_after(const std::vector<std::string>& lines, const std::string& name) {
  for (const std::string& line : lines) {
    if (line.starts_with(name + " ")) return line.substr(name.size() + 1);
  }
  return {};
}

bool is_version(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

std::string wrong_answer(const ProgramOutput& answer) {
  if (!answer.exit) return "timeout";
  const std::string last_line =
      answer.lines.empty() ? "prints nothing" : fmt::format("prints '{}'", answer.lines.front());
  return fmt::format("{}, {}", last_line, to_text(*answer.exit));
}

// Missing if not found, wrong if it prints no version, otherwise ok with version and path.
// `version` is the parsed version.
DoctorCheck evaluate_version(const ProgramOutput& answer, std::string name, std::string purpose,
                             std::string version) {
  DoctorCheck check;
  check.name = std::move(name);
  check.purpose = std::move(purpose);

  check.path = answer.path.string();

  if (answer.path.empty()) {
    check.status = DoctorStatus::kMissing;
    check.found = "not on PATH";
  } else if (!answer.started()) {
    check.status = DoctorStatus::kWrong;
    check.found = answer.absence;
  } else if (!is_version(version)) {
    check.status = DoctorStatus::kWrong;
    check.found = fmt::format("{}: {}", check.path, wrong_answer(answer));
  } else {
    check.version = std::move(version);
    check.found = fmt::format("{}, {}", check.version, check.path);
  }
  return check;
}

// "3.11.2, grpc 1.51.1, google.protobuf missing, /usr/bin/python3": true if all are installed.
bool add_packages(DoctorCheck& check, const ProgramOutput& answer,
                  const std::vector<std::string>& packages) {
  bool complete = true;
  std::string found = check.version;
  for (const std::string& package : packages) {
    const std::string version = text_after(answer.lines, package);
    complete = complete && is_version(version);
    found += fmt::format(", {} {}", package, version.empty() ? "missing" : version);
  }

  check.found = fmt::format("{}, {}", found, check.path);
  if (!complete) check.status = DoctorStatus::kMissing;
  return complete;
}

DoctorCheck judge_soccer_server(const ProgramOutput& answer) {
  constexpr std::string_view kName = "rcssserver-";
  std::string version;
  for (const std::string& line : answer.lines) {
    if (version.empty() && line.starts_with(kName)) version = line.substr(kName.size());
  }

  DoctorCheck check = evaluate_version(
      answer, "rcssserver", "--server rcssserver; not needed by the embedded server", version);

  const bool no_library =
      !answer.lines.empty() && answer.lines.front().find("shared librar") != std::string::npos;
  if (no_library) {
    check.hint =
        "ldconfig as root, or LD_LIBRARY_PATH=PREFIX/lib with the prefix of its installation";
  } else if (check.status == DoctorStatus::kMissing || check.status == DoctorStatus::kWrong) {
    check.hint = fmt::format(
        "not in Debian: {}; then build rcssserver 19 from source: ./bootstrap && ./configure && "
        "make "
        "&& make install && ldconfig",
        install_command(kServerBuild));
  } else if (!check.version.starts_with(kTestedServer)) {
    check.found += "; cls is tested with rcssserver 19";
  }
  return check;
}

DoctorCheck judge_python(const ProgramOutput& answer) {
  DoctorCheck check = evaluate_version(answer, "python3", "Playmakers in Python, examples/python",
                                       text_after(answer.lines, "python"));

  const bool is_debian_python = check.path == "/usr/bin/python3" || check.path == "/bin/python3";
  if (check.status == DoctorStatus::kMissing) {
    check.hint = install_command("python3 python3-grpcio python3-protobuf");
  } else if (check.status == DoctorStatus::kWrong) {
    check.hint = "run it by hand: python3 --version";
  } else if (!add_packages(check, answer, {"grpc", "google.protobuf"})) {
    const std::string debian_packages = install_command("python3-grpcio python3-protobuf");
    check.hint = is_debian_python
                     ? debian_packages
                     : fmt::format(
                           "{} -m pip install grpcio protobuf; or {}, and run "
                           "Playmakers with /usr/bin/python3; or ./bootstrap python in "
                           "the checkout of cls",
                           check.path, debian_packages);
  } else if (text_after(answer.lines, "cls_playmaker") != "installed") {
    // Other Playmakers in Python do without.
    check.found +=
        "; cls_playmaker missing: ./bootstrap python in the checkout of cls makes an environment "
        "with it";
  }

  return check;
}

DoctorCheck judge_node(const ProgramOutput& answer) {
  DoctorCheck check = evaluate_version(answer, "node", "Playmakers in JavaScript",
                                       text_after(answer.lines, "node"));
  if (check.status == DoctorStatus::kMissing) {
    check.hint = install_command("nodejs npm");
  } else if (check.status == DoctorStatus::kWrong) {
    check.hint = "run it by hand: node --version";
  } else if (!add_packages(check, answer, {"@grpc/grpc-js", "@grpc/proto-loader"})) {
    check.hint = "in the Playmaker's folder: npm install @grpc/grpc-js @grpc/proto-loader";
    if (!process::find_program("npm")) check.hint += "; npm: " + install_command("npm");
  }
  return check;
}

DoctorCheck judge_protobuf_compiler(const ProgramOutput& answer) {
  constexpr const char* kPackages = "protobuf-compiler protobuf-compiler-grpc";
  DoctorCheck check =
      evaluate_version(answer, "protoc", "classes of proto/playmaker.proto for your own Playmaker",
                       text_after(answer.lines, "libprotoc"));

  if (check.status == DoctorStatus::kOk && !process::find_program("grpc_python_plugin")) {
    check.status = DoctorStatus::kMissing;
    check.found += ", grpc_python_plugin missing";
  }
  if (check.status != DoctorStatus::kOk) check.hint = install_command(kPackages);
  return check;
}

DoctorCheck judge_slurm(const ProgramOutput& answer) {
  DoctorCheck check = evaluate_version(answer, "slurm", "tournaments on a cluster",
                                       text_after(answer.lines, "slurm"));

  if (check.status == DoctorStatus::kMissing) {
    check.hint = install_command("slurm-client");
    return check;
  }

  std::string absent;
  for (const char* command : {"squeue", "scancel", "scontrol"}) {
    if (!process::find_program(command)) absent += fmt::format(", {} missing", command);
  }

  const bool fails =
      check.status == DoctorStatus::kWrong && answer.exit && answer.exit->number != 0;
  if (fails && !answer.lines.empty()) {
    // Without slurm.conf the commands fail even with --version.
    check.status = DoctorStatus::kUnreachable;
    check.found = fmt::format("{}: {}", check.path, answer.lines.back());
    check.hint = "run on a host of the cluster, or set SLURM_CONF to its slurm.conf";
  } else if (check.status == DoctorStatus::kWrong) {
    check.hint = "run it by hand: sbatch --version";
  } else if (!absent.empty()) {
    check.status = DoctorStatus::kMissing;
    check.found += absent;
    check.hint = install_command("slurm-client");
  }
  return check;
}

}  // namespace

ProgramCheck soccer_server_program(const std::filesystem::path& scratch) {
  return {{"rcssserver", {"--help"}, scratch, match::server_environment(scratch)},
          judge_soccer_server};
}

ProgramCheck python() { return {{"python3", {"-c", kPythonScript}, {}, {}}, judge_python}; }

ProgramCheck node() { return {{"node", {"-e", kNodeScript}, {}, {}}, judge_node}; }

ProgramCheck protobuf_compiler() {
  return {{"protoc", {"--version"}, {}, {}}, judge_protobuf_compiler};
}

ProgramCheck slurm() { return {{"sbatch", {"--version"}, {}, {}}, judge_slurm}; }

}  // namespace cls::checks
