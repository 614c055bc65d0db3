// A program on a terminal of its own, for what only interactive programs do.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace cls::tests {

/// A program with a terminal of 200 columns as input and output. The destructor kills it.
class PseudoTerminal {
 public:
  /// As Command: `arguments[0]` is the program, `environment` is added to the inherited one.
  PseudoTerminal(std::vector<std::string> arguments, std::vector<std::string> environment,
                 const std::filesystem::path& working_folder);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Types `keys`; "\t" is the tabulator key.
  void type(const std::string& keys) const;
  /// Waits until the terminal shows `text` after what earlier calls waited for; false after `limit`
  /// or at the end of the program.
  bool wait_for(const std::string& text, std::chrono::seconds limit = std::chrono::seconds(30));
  /// All that the terminal has shown.
  const std::string& shown() const { return shown_; }

 private:
  pid_t pid_ = -1;
  int terminal_ = -1;
  std::string shown_;
  std::size_t seen_ = 0;  ///< of shown_, by wait_for()
};

}  // namespace cls::tests
