// Home folders from the environment and the user database.
#include "base/io/home_path.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace cls::base {
namespace {

// Empty: unknown. `user` is empty for the one who runs this program.
std::string home_of(const std::string& user) {
  const char* variable = std::getenv("HOME");
  if (user.empty() && variable != nullptr && *variable != '\0') return variable;
  const passwd* entry = user.empty() ? ::getpwuid(::getuid()) : ::getpwnam(user.c_str());
  return entry == nullptr || entry->pw_dir == nullptr ? "" : entry->pw_dir;
}

}  // namespace

std::string expand_home(std::string_view path) {
  if (!path.starts_with('~')) return std::string(path);
  const std::size_t end = path.find('/');
  const std::string home = home_of(std::string(path.substr(1, end == path.npos ? end : end - 1)));
  if (home.empty()) return std::string(path);
  return home + std::string(end == path.npos ? std::string_view() : path.substr(end));
}

}  // namespace cls::base
