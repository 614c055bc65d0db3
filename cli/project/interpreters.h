// Interpreters that a Playmaker needs besides its own files, and where they come from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/project/bundle.h"

namespace cls::cli {

/// A project for which interpreters are found.
struct InterpretedProject {
  std::string command;  ///< that starts its Playmaker
  std::filesystem::path folder;
  std::filesystem::path environment;  ///< a virtual environment of Python; empty: none
};

/// True for a folder with a project in C# (.csproj).
bool is_for_dotnet(const std::filesystem::path& folder);

/// The programs that start the Playmaker, as far as the project shows: python3 of its environment
/// or of PATH for Python, node for package.json. Empty: it is a program itself.
std::vector<std::filesystem::path> interpreters_of(const InterpretedProject& project);

/// The files that come along with one of them.
struct BroughtInterpreter {
  std::string name;                   ///< "python3", "node"
  std::filesystem::path program;      ///< of this host
  std::vector<std::string> packages;  ///< of Python: "grpc", "google/protobuf"
};

/// Copies an interpreter to env/ of `package`; from Python the standard library without its tests,
/// too, the packages of the environment, and what the project imports. Errors name the program.
base::Result<BroughtInterpreter> bring_interpreter(const std::filesystem::path& program,
                                                   const InterpretedProject& project,
                                                   const std::filesystem::path& package,
                                                   Bundle& bundle);

}  // namespace cls::cli
