// Questions to programs and the reading of their answers.
#include "orchestration/checks/doctor/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "orchestration/match/options/server_command.h"

namespace cls::orchestration::checks {
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

// What stands behind "NAME " in the first line that begins so; empty without one.
std::string behind(const std::vector<std::string>& lines, const std::string& name) {
  for (const std::string& line : lines) {
    if (line.starts_with(name + " ")) return line.substr(name.size() + 1);
  }
  return {};
}

bool is_version(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

std::string how_it_ended(const ProgramAnswer& answer) {
  if (!answer.exit) return "no answer within the time limit";
  const std::string words =
      answer.lines.empty() ? "prints nothing" : fmt::format("prints '{}'", answer.lines.front());
  return fmt::format("{}, {}", words, to_text(*answer.exit));
}

// A program that is not there, or does not say its version; `ok` of one that does, with version
// and path filled in. `version` is what was understood.
Symptom judged(const ProgramAnswer& answer, std::string name, std::string purpose,
               std::string version) {
  Symptom symptom;
  symptom.name = std::move(name);
  symptom.purpose = std::move(purpose);
  symptom.path = answer.path.string();
  if (answer.path.empty()) {
    symptom.health = Health::kMissing;
    symptom.found = "not on PATH";
  } else if (!answer.started()) {
    symptom.health = Health::kWrong;
    symptom.found = answer.absence;
  } else if (!is_version(version)) {
    symptom.health = Health::kWrong;
    symptom.found = fmt::format("{}: {}", symptom.path, how_it_ended(answer));
  } else {
    symptom.version = std::move(version);
    symptom.found = fmt::format("{}, {}", symptom.version, symptom.path);
  }
  return symptom;
}

// "3.11.2, grpc 1.51.1, google.protobuf missing, /usr/bin/python3": true if all are there.
bool add_packages(Symptom& symptom, const ProgramAnswer& answer,
                  const std::vector<std::string>& packages) {
  bool complete = true;
  std::string found = symptom.version;
  for (const std::string& package : packages) {
    const std::string version = behind(answer.lines, package);
    complete = complete && is_version(version);
    found += fmt::format(", {} {}", package, version.empty() ? "missing" : version);
  }
  symptom.found = fmt::format("{}, {}", found, symptom.path);
  if (!complete) symptom.health = Health::kMissing;
  return complete;
}

Symptom judge_soccer_server(const ProgramAnswer& answer) {
  constexpr std::string_view kName = "rcssserver-";
  std::string version;
  for (const std::string& line : answer.lines) {
    if (version.empty() && line.starts_with(kName)) version = line.substr(kName.size());
  }
  Symptom symptom =
      judged(answer, "rcssserver", "--server rcssserver; the embedded server needs none", version);
  const bool no_library =
      !answer.lines.empty() && answer.lines.front().find("shared librar") != std::string::npos;
  if (no_library) {
    symptom.remedy = "ldconfig as root, or LD_LIBRARY_PATH=PREFIX/lib of where it was installed";
  } else if (symptom.health == Health::kMissing || symptom.health == Health::kWrong) {
    symptom.remedy = fmt::format(
        "not in Debian: {}; then in the source of rcssserver 19: ./bootstrap && ./configure && "
        "make "
        "&& make install && ldconfig",
        install_command(kServerBuild));
  } else if (!symptom.version.starts_with(kTestedServer)) {
    symptom.found += "; cls is tested with rcssserver 19";
  }
  return symptom;
}

Symptom judge_python(const ProgramAnswer& answer) {
  Symptom symptom = judged(answer, "python3", "Playmakers in Python, examples/python",
                           behind(answer.lines, "python"));
  const bool is_debians = symptom.path == "/usr/bin/python3" || symptom.path == "/bin/python3";
  if (symptom.health == Health::kMissing) {
    symptom.remedy = install_command("python3 python3-grpcio python3-protobuf");
  } else if (symptom.health == Health::kWrong) {
    symptom.remedy = "see what it says: python3 --version";
  } else if (!add_packages(symptom, answer, {"grpc", "google.protobuf"})) {
    const std::string debians = install_command("python3-grpcio python3-protobuf");
    symptom.remedy = is_debians ? debians
                                : fmt::format(
                                      "{} -m pip install grpcio protobuf; or {}, and call "
                                      "Playmakers with /usr/bin/python3",
                                      symptom.path, debians);
  }
  return symptom;
}

Symptom judge_node(const ProgramAnswer& answer) {
  Symptom symptom =
      judged(answer, "node", "Playmakers in JavaScript", behind(answer.lines, "node"));
  if (symptom.health == Health::kMissing) {
    symptom.remedy = install_command("nodejs npm");
  } else if (symptom.health == Health::kWrong) {
    symptom.remedy = "see what it says: node --version";
  } else if (!add_packages(symptom, answer, {"@grpc/grpc-js", "@grpc/proto-loader"})) {
    symptom.remedy = "in the Playmaker's folder: npm install @grpc/grpc-js @grpc/proto-loader";
    if (!process::find_program("npm")) symptom.remedy += "; npm: " + install_command("npm");
  }
  return symptom;
}

Symptom judge_protobuf_compiler(const ProgramAnswer& answer) {
  constexpr const char* kPackages = "protobuf-compiler protobuf-compiler-grpc";
  Symptom symptom =
      judged(answer, "protoc", "classes of proto/playmaker.proto for a Playmaker of your own",
             behind(answer.lines, "libprotoc"));
  if (symptom.health == Health::kOk && !process::find_program("grpc_python_plugin")) {
    symptom.health = Health::kMissing;
    symptom.found += ", grpc_python_plugin missing";
  }
  if (symptom.health != Health::kOk) symptom.remedy = install_command(kPackages);
  return symptom;
}

Symptom judge_slurm(const ProgramAnswer& answer) {
  Symptom symptom =
      judged(answer, "slurm", "tournaments on a cluster", behind(answer.lines, "slurm"));
  if (symptom.health == Health::kMissing) {
    symptom.remedy = install_command("slurm-client");
    return symptom;
  }
  std::string absent;
  for (const char* command : {"squeue", "scancel", "scontrol"}) {
    if (!process::find_program(command)) absent += fmt::format(", {} missing", command);
  }
  const bool fails = symptom.health == Health::kWrong && answer.exit && answer.exit->number != 0;
  if (fails && !answer.lines.empty()) {
    // Without a cluster's configuration the commands do not even tell their version.
    symptom.health = Health::kUnreachable;
    symptom.found = fmt::format("{}: {}", symptom.path, answer.lines.back());
    symptom.remedy = "go to a machine of the cluster, or name its slurm.conf in SLURM_CONF";
  } else if (symptom.health == Health::kWrong) {
    symptom.remedy = "see what it says: sbatch --version";
  } else if (!absent.empty()) {
    symptom.health = Health::kMissing;
    symptom.found += absent;
    symptom.remedy = install_command("slurm-client");
  }
  return symptom;
}

}  // namespace

ProgramExamination soccer_server_program(const std::filesystem::path& scratch) {
  return {{"rcssserver", {"--help"}, scratch, match::server_environment(scratch)},
          judge_soccer_server};
}

ProgramExamination python() { return {{"python3", {"-c", kPythonScript}, {}, {}}, judge_python}; }

ProgramExamination node() { return {{"node", {"-e", kNodeScript}, {}, {}}, judge_node}; }

ProgramExamination protobuf_compiler() {
  return {{"protoc", {"--version"}, {}, {}}, judge_protobuf_compiler};
}

ProgramExamination slurm() { return {{"sbatch", {"--version"}, {}, {}}, judge_slurm}; }

}  // namespace cls::orchestration::checks
