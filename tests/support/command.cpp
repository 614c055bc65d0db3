// Runs a program and waits for it.
#include "tests/support/command.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <thread>

#include "tests/support/files.h"

namespace cls::tests {
namespace {

constexpr std::chrono::milliseconds kPoll{10};

void redirect(const std::filesystem::path& path, int flags, int descriptor) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
  if (file != descriptor) close(file);
}

}  // namespace

std::filesystem::path cls_binary() { return std::filesystem::path(CLS_BINARY); }

Command::Command(std::vector<std::string> arguments, std::vector<std::string> environment,
                 const std::filesystem::path& working_folder) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const std::filesystem::path out = folder_.path() / "out";
  const std::filesystem::path err = folder_.path() / "err";
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid_ > 0) return;
  redirect("/dev/null", O_RDONLY, STDIN_FILENO);
  redirect(out, O_WRONLY | O_CREAT | O_APPEND, STDOUT_FILENO);
  redirect(err, O_WRONLY | O_CREAT | O_APPEND, STDERR_FILENO);
  for (std::string& line : environment) putenv(line.data());
  if (!working_folder.empty() && chdir(working_folder.c_str()) != 0) _exit(126);
  execvp(argv[0], argv.data());
  _exit(127);
}

Command::~Command() {
  if (ended_ || collect(true)) return;
  kill(pid_, SIGKILL);
  collect(false);
}

bool Command::collect(bool block_not) {
  if (ended_) return true;
  ended_ = waitpid(pid_, &status_, block_not ? WNOHANG : 0) == pid_;
  return ended_;
}

void Command::send_signal(int signal) const { kill(pid_, signal); }

std::string Command::printed(const char* stream) const {
  const std::filesystem::path file = folder_.path() / stream;
  return std::filesystem::exists(file) ? read_file(file) : "";
}

std::string Command::out() const { return printed("out"); }

bool Command::wait_for_output(const std::string& text, std::chrono::seconds limit) {
  return wait_for("out", text, limit);
}

bool Command::wait_for_errors(const std::string& text, std::chrono::seconds limit) {
  return wait_for("err", text, limit);
}

bool Command::wait_for(const char* stream, const std::string& text, std::chrono::seconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (printed(stream).find(text) == std::string::npos) {
    if (collect(true) || std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

CommandResult Command::finish(std::chrono::seconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (!collect(true) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(kPoll);
  }
  CommandResult result;
  if (!ended_) {
    kill(pid_, SIGKILL);
    collect(false);
  } else if (WIFEXITED(status_)) {
    result.exit_code = WEXITSTATUS(status_);
  } else if (WIFSIGNALED(status_)) {
    result.signal = WTERMSIG(status_);
  }
  result.out = out();
  result.err = read_file(folder_.path() / "err");
  return result;
}

CommandResult run(std::vector<std::string> arguments, std::vector<std::string> environment) {
  return Command(std::move(arguments), std::move(environment)).finish();
}

}  // namespace cls::tests
