// The languages of the example teams, for tests of projects and of code in the documentation.
#include "tests/support/language.h"

#include <algorithm>
#include <ostream>
#include <regex>

#include "tests/support/command.h"
#include "tests/support/python.h"

namespace cls::tests {
namespace {

bool is_on_path(const std::string& tool) {
  return run({"sh", "-c", "command -v " + tool}).exit_code == 0;
}

// Version {1, 88} of "cargo 1.88.0 (873a06493 2025-05-10)".
std::pair<int, int> version_in(const std::string& text) {
  static const std::regex version(R"((\d+)\.(\d+))");
  std::smatch found;
  if (!std::regex_search(text, found, version)) return {};
  return {std::stoi(found[1]), std::stoi(found[2])};
}

}  // namespace

void PrintTo(const Language& language, std::ostream* out) { *out << language.name; }

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {
      {"python", {"protoc", "grpc_python_plugin"}},
      {"javascript", {"node", "npm"}, {"node", "--version"}, {18, 0}},
      {"typescript", {"node", "npm"}, {"node", "--version"}, {18, 0}},
      {"go", {"go", "protoc"}, {"go", "version"}, {1, 26}},
      {"java", {"javac", "mvn"}, {"javac", "-version"}, {17, 0}},
      {"rust", {"cargo", "cc"}, {"cargo", "--version"}, {1, 88}},
      {"csharp", {"dotnet"}, {"dotnet", "--version"}, {8, 0}},
  };
  return all;
}

std::string why_missing(const Language& language) {
  for (const std::string& tool : language.tools) {
    if (!is_on_path(tool)) return language.name + ": no " + tool + " on PATH";
  }
  if (!language.version.empty()) {
    const CommandResult version = run(language.version);
    if (version_in(version.out + version.err) < language.least) {
      return language.name + ": needs " + language.tools[0] + " " +
             std::to_string(language.least.first) + "." + std::to_string(language.least.second) +
             ", not " + version.out + version.err;
    }
  }
  if (language.name == "python" && python_with_grpc().empty()) return kNoPython;
  return {};
}

std::string why_missing(const std::string& language) {
  const auto& all = languages();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Language& each) { return each.name == language; });
  return found == all.end() ? language + ": unknown language" : why_missing(*found);
}

bool is_about_network(const std::string& output) {
  for (const char* phrase :
       {"Could not transfer artifact", "Could not resolve", "EAI_AGAIN", "ENOTFOUND",
        "ECONNREFUSED", "ETIMEDOUT", "dial tcp", "failed to download",
        "failed to query replaced source", "Couldn't connect to server", "network failure",
        "error NU1301", "npm error network", "npm ERR! network", "ECONNRESET",
        "ERR_SOCKET_TIMEOUT"}) {
    if (output.find(phrase) != std::string::npos) return true;
  }
  return false;
}

}  // namespace cls::tests
