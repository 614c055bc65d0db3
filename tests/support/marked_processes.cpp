// Reads /proc/PID/environ of every process.
#include "tests/support/marked_processes.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace cls::tests {

namespace fs = std::filesystem;

std::string new_mark() {
  static std::atomic<int> next{0};
  return std::to_string(::getpid()) + "-" + std::to_string(++next);
}

std::vector<int> marked_processes(const std::string& mark) {
  const std::string wanted = std::string(1, '\0') + kMarkVariable + "=" + mark + '\0';
  std::vector<int> pids;
  std::error_code code;
  for (fs::directory_iterator entry("/proc", code), end; !code && entry != end;
       entry.increment(code)) {
    const int pid = std::atoi(entry->path().filename().c_str());
    if (pid <= 0) continue;
    std::ifstream file(entry->path() / "environ", std::ios::binary);
    std::string text(1, '\0');
    text.append(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    if (text.find(wanted) != std::string::npos) pids.push_back(pid);
  }
  return pids;
}

bool all_marked_gone(const std::string& mark, std::chrono::milliseconds limit) {
  const auto until = std::chrono::steady_clock::now() + limit;
  while (!marked_processes(mark).empty()) {
    if (std::chrono::steady_clock::now() >= until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace cls::tests
