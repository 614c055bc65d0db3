// `cls doctor`: options and table.
#include "cli/check/doctor_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/terminal.h"
#include "orchestration/checks/doctor/doctor.h"

namespace cls::cli {
namespace {

using orchestration::checks::Diagnosis;
using orchestration::checks::Health;
using orchestration::checks::Symptom;
using orchestration::match::Endpoint;

constexpr const char* kDescription =
    "Tells what is here, what is missing, and the command that gets it.\n"
    "\n"
    "  cls doctor                                this machine and its programs\n"
    "  cls doctor --server rcssserver            does it start, does it answer?\n"
    "  cls doctor --server localhost:6000        one that runs: is it a soccer server, and how "
    "far?\n"
    "  cls doctor --playmaker localhost:50051    can your Playmaker be asked?\n"
    "  cls doctor --json                         for scripts\n"
    "\n"
    "Changes nothing, joins no match. What is missing is no failure unless cls cannot play without "
    "it\n"
    "or you asked for it; then the exit code is 1, or 69 when nobody could be reached.";

struct Arguments {
  std::string server;
  std::string playmaker;
  TlsOptions tls;
  double limit_s = 5.0;
  bool json = false;
  bool no_colour = false;
};

const char* colour_of(Health health, bool needed) {
  constexpr const char* kGreen = "\x1b[32m";
  constexpr const char* kYellow = "\x1b[33m";
  constexpr const char* kRed = "\x1b[31m";
  if (health == Health::kOk) return kGreen;
  return needed ? kRed : kYellow;
}

void print_row(const Symptom& symptom, bool colour) {
  const std::string status = fmt::format("{:<11}", name(symptom.health));
  const std::string shown =
      colour ? fmt::format("{}{}\x1b[0m", colour_of(symptom.health, symptom.needed), status)
             : status;
  fmt::print("{}  {:<13}  {}\n", shown, symptom.name, symptom.found);
  if (symptom.health != Health::kOk) {
    fmt::print("{:28}for: {}\n", "", symptom.purpose);
    if (!symptom.remedy.empty()) fmt::print("{:28}do:  {}\n", "", symptom.remedy);
  }
  std::fflush(stdout);
}

void print_summary(const Diagnosis& diagnosis) {
  std::string lacking;
  for (const Symptom& symptom : diagnosis.symptoms) {
    if (symptom.needed && symptom.health != Health::kOk) {
      lacking += (lacking.empty() ? "" : ", ") + symptom.name;
    }
  }
  if (lacking.empty()) {
    fmt::print("\nReady to play: cls match mock mock\n");
  } else {
    fmt::print("\nNot in order: {}\n", lacking);
  }
}

int exit_code_of(const Diagnosis& diagnosis, int interrupted) {
  if (interrupted == SIGINT) return kInterrupted;
  if (interrupted == SIGTERM) return kTerminated;
  if (diagnosis.unreachable()) return kUnavailable;
  return diagnosis.healthy() ? kDone : kAnswerIsNo;
}

int complain(const std::string& message) {
  fmt::print(stderr, "cls: {}\n", message);
  return kUsage;
}

int run_doctor(const Arguments& arguments) {
  orchestration::checks::DoctorOptions options;
  options.own_program = std::filesystem::read_symlink("/proc/self/exe").string();
  options.limit = std::chrono::milliseconds(static_cast<int>(arguments.limit_s * 1000.0));
  if (!arguments.server.empty()) {
    auto server = orchestration::match::parse_server(arguments.server);
    if (!server) return complain(server.error().message);
    options.server = *std::move(server);
  }
  if (!arguments.playmaker.empty()) {
    auto endpoint = orchestration::match::parse_endpoint(arguments.playmaker);
    if (!endpoint) return complain(endpoint.error().message);
    if (!endpoint->has_playmaker()) {
      return complain("--playmaker: team:DIR has no Playmaker to ask");
    }
    if (const int read = read_tls_files(*endpoint, arguments.tls); read != kDone) return read;
    options.playmaker = *std::move(endpoint);
  }
  const std::atomic<int>& interrupted = watch_interrupts();
  const bool colour = stdout_takes_colour(arguments.no_colour);
  const auto on_symptom = [&](const Symptom& symptom) {
    if (!arguments.json) print_row(symptom, colour);
  };
  const Diagnosis diagnosis = orchestration::checks::examine(options, on_symptom, interrupted);
  if (arguments.json) {
    fmt::print("{}", orchestration::checks::to_json(diagnosis));
  } else {
    print_summary(diagnosis);
  }
  return exit_code_of(diagnosis, interrupted);
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("doctor", kDescription);
  command->add_option("--server", arguments->server,
                      "try a server: rcssserver, PATH, embedded (started for a moment), HOST:PORT");
  command->add_option("--playmaker", arguments->playmaker,
                      "try a Playmaker: HOST:PORT, HOST:PORT+step, tls:HOST:PORT, unix:PATH, "
                      "run:COMMAND");
  add_tls_options(*command, arguments->tls);
  command
      ->add_option("--start-timeout", arguments->limit_s,
                   "seconds that each program and each probe has to answer (5)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", arguments->json, "one JSON document instead of the table");
  command->add_flag("--no-color", arguments->no_colour, "no colour on a terminal");
  command->callback([arguments, &exit_code] { exit_code = run_doctor(*arguments); });
}

}  // namespace cls::cli
