// Reads the first simple command as the shell would.
#include "match/programs/run_command_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "process/command_plan.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;

struct ShellWord {
  std::string text;
  bool plain = true;  // the shell expands nothing in it
  bool ends = false;  // an operator: ; & | and their doubles
};

bool is_operator(char c) { return std::string_view(";&|\n").find(c) != std::string_view::npos; }
bool is_space(char c) { return c == ' ' || c == '\t'; }

std::vector<ShellWord> shell_words(std::string_view command) {
  constexpr std::string_view kExpanded = "$`*?[](){}<>~#\\";
  std::vector<ShellWord> words;
  for (std::size_t i = 0; i < command.size();) {
    if (is_space(command[i])) {
      ++i;
      continue;
    }

    ShellWord word;
    if (is_operator(command[i])) {
      word.ends = true;
      while (i < command.size() && is_operator(command[i])) word.text += command[i++];
    } else {
      char quote = 0;
      for (; i < command.size(); ++i) {
        const char c = command[i];
        if (quote == 0 && (is_space(c) || is_operator(c))) break;
        if (c == quote || (quote == 0 && (c == '\'' || c == '"'))) {
          quote = quote == 0 ? c : 0;
          continue;
        }

        if (quote == 0 && c == '\\' && i + 1 < command.size()) {
          word.text += command[++i];
          continue;
        }

        if (quote != '\'' && kExpanded.find(c) != std::string_view::npos) word.plain = false;
        word.text += c;
      }
    }

    words.push_back(std::move(word));
  }
  return words;
}

bool is_assignment(const std::string& word) {
  const std::size_t equals = word.find('=');
  return equals != std::string::npos && equals > 0 && word.find('/') > equals;
}

// Words after which a command follows.
constexpr std::string_view kCommandPrefixes[] = {"env", "exec", "nohup", "time"};

// Commands and keywords of the shell itself that a command may begin with.
constexpr std::string_view kBuiltins[] = {
    ".",    "!",    "case", "command", "echo", "eval", "exit", "export", "for",   "if",
    "kill", "read", "set",  "sleep",   "test", "trap", "true", "ulimit", "umask", "while"};

// Extensions of scripts.
constexpr std::string_view kScripts[] = {".py", ".js", ".mjs", ".ts", ".rb", ".sh", ".jar"};

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

std::string missing_program(const std::string& program, const fs::path& folder) {
  if (is_one_of(kBuiltins, program)) return {};
  const bool is_path = program.find('/') != std::string::npos;
  const auto found = process::find_program(is_path ? (folder / program).string() : program);
  return found ? std::string() : found.error().message;
}

}  // namespace

std::string missing_in_command(std::string_view command, fs::path folder) {
  const std::vector<ShellWord> words = shell_words(command);
  std::string program;

  for (std::size_t i = 0; i < words.size(); ++i) {
    const ShellWord& word = words[i];
    if (word.ends || !word.plain) return {};

    if (program.empty() && word.text == "cd" && i + 2 < words.size() && words[i + 1].plain &&
        words[i + 2].text == "&&") {
      folder /= words[i + 1].text;
      std::error_code code;
      if (!fs::is_directory(folder, code)) return folder.string() + ": no such folder";
      i += 2;
    } else if (program.empty()) {
      if (word.text == "cd") return {};  // to a folder that the shell expands
      if (is_assignment(word.text) || is_one_of(kCommandPrefixes, word.text)) continue;
      program = word.text;
      if (std::string missing = missing_program(program, folder); !missing.empty()) return missing;
    } else if (is_one_of(kScripts, fs::path(word.text).extension().string())) {
      std::error_code code;
      const bool exists = fs::exists(folder / word.text, code);
      return exists ? std::string() : fmt::format("{}: no such file", word.text);
    } else if (!word.text.starts_with("-")) {
      return {};
    }
  }
  return {};
}

}  // namespace cls::match
