#!/usr/bin/env python3
"""Commands and agents side by side: this build and, optionally, another one.

    bench/commands.py                         build/bin/cls alone
    bench/commands.py --base OTHER/bin/cls    alternating with another build

Prints two tables, medians over the rounds:
    commands: milliseconds of a clock and of CPU until a command ends; game logs are a recorded
              match of 23 MB and its text log (CLS_DATA), else a match that is played first
    agents:   microseconds of CPU of an agent's cycle by part, without a call (cls_bench beside the
              binary, CLS_DATA)
The ratio says how many times as fast this build is, by CPU. Environment, each optional:
    CLS_BENCH_BASE      as --base
    CLS_DATA            recorded matches
    CLS_RCG_PRINTER     rcgresultprinter of librcsc; printed beside `cls results`
"""
import argparse
import gzip
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
RECORDED = "logs/helios-vs-helios-full"
NAME_WIDTH = 40


def options():
    parser = argparse.ArgumentParser(description="Commands of two builds, side by side.")
    parser.add_argument("--cls", default=str(ROOT / "build/bin/cls"), help="binary to measure")
    parser.add_argument("--base", default=os.environ.get("CLS_BENCH_BASE", ""),
                        help="binary to compare with")
    parser.add_argument("--rounds", type=int, default=5, help="of each row (default: 5)")
    parser.add_argument("--only", default="", help="rows whose name has this regular expression")
    return parser.parse_args()


def make_logs(binary, folder):
    """Writes match.rcg and match.rcl of a whole match to `folder`."""
    recorded = os.path.join(os.environ.get("CLS_DATA", ""), RECORDED)
    for ending in ("rcg", "rcl"):
        packed = f"{recorded}.{ending}.gz"
        if not os.path.exists(packed):
            subprocess.run([binary, "match", "mock", "mock", "--seed", "7", "--quiet", "--force",
                            "--dir", folder], check=True, stdout=subprocess.DEVNULL)
            return
        with gzip.open(packed) as source, open(f"{folder}/match.{ending}", "wb") as out:
            shutil.copyfileobj(source, out)


def rows(folder):
    """Name and arguments of each command."""
    log = f"{folder}/match.rcg"
    page = f"{folder}/page.html"
    yield "cls --help", ["--help"]
    yield ("cls match mock mock --cycles 1",
           ["match", "mock", "mock", "--cycles", "1", "--seed", "7", "--force",
            "--dir", f"{folder}/short"])
    yield "cls watch, page of a whole match", ["watch", log, "--no-open", "--out", page]
    yield "cls results", ["results", log]
    yield "cls stats, with the text log", ["stats", log]


def run(command):
    """Milliseconds of the clock and of CPU."""
    began = time.monotonic()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True) as program:
        errors = program.stderr.read()
        _, status, usage = os.wait4(program.pid, 0)
        program.returncode = os.waitstatus_to_exitcode(status)
    if program.returncode != 0:
        sys.exit(f"bench/commands.py: {' '.join(command)}: {errors.strip()}")
    return 1e3 * (time.monotonic() - began), 1e3 * (usage.ru_utime + usage.ru_stime)


def medians(commands, rounds):
    """Of each command; they take turns."""
    figures = [[] for _ in commands]
    for _ in range(rounds):
        for command, measured in zip(commands, figures):
            measured.append(run(command))
    return [[statistics.median(column) for column in zip(*measured)] for measured in figures]


def ratio(figures):
    """How many times as fast the second build is."""
    return f" | {figures[0] / figures[1]:5.2f} x" if len(figures) == 2 else ""


def print_commands(binaries, args):
    with tempfile.TemporaryDirectory() as folder:
        make_logs(binaries[-1], folder)
        print(f"{'command':{NAME_WIDTH}}" + f" | {'ms':>7} {'CPU ms':>7}" * len(binaries))

        printer = os.environ.get("CLS_RCG_PRINTER")
        for name, arguments in rows(folder):
            if not re.search(args.only, name):
                continue
            commands = [[binary, *arguments] for binary in binaries]
            if printer and name == "cls results":
                commands.append([printer, f"{folder}/match.rcg"])
            found = medians(commands, args.rounds)
            print_row(name, found[:len(binaries)])
            if len(found) > len(binaries):
                print_row("  rcgresultprinter", found[-1:])


def print_row(name, found):
    cells = "".join(f" | {clock:7.1f} {cpu:7.1f}" for clock, cpu in found)
    print(f"{name:{NAME_WIDTH}}{cells}{ratio([cpu for _, cpu in found])}", flush=True)


def agent_parts(binary):
    """Microseconds by part, as agent_bench.cpp names them; none without cls_bench or CLS_DATA."""
    bench = os.path.join(os.path.dirname(binary), "cls_bench")
    if not os.path.exists(bench):
        return {}
    text = subprocess.run([bench, "--benchmark_filter=^agent/", "--benchmark_format=json"],
                          capture_output=True, text=True, check=True).stdout
    return {run["name"].split("/")[1]: run["real_time"] for run in json.loads(text)["benchmarks"]
            if "error_occurred" not in run}


def print_agents(binaries, args):
    rounds = [[agent_parts(binary) for binary in binaries] for _ in range(args.rounds)]
    builds = list(zip(*rounds))
    if not builds[-1][0]:
        print("\nskipped: agents: no cls_bench beside the binary, or no CLS_DATA")
        return

    print(f"\n{'agent, us a cycle':{NAME_WIDTH}}" + f" | {'us':>7}" * len(binaries))
    for part in builds[-1][0]:
        known = [build for build in builds if build[0]]
        figures = [statistics.median(found[part] for found in build) for build in known]
        older = f" | {'-':>7}" * (len(builds) - len(known))  # without cls_bench
        cells = "".join(f" | {us:7.1f}" for us in figures)
        print(f"{part.replace('_', ' '):{NAME_WIDTH}}{older}{cells}{ratio(figures)}", flush=True)


def main():
    args = options()
    binaries = [args.base, args.cls] if args.base else [args.cls]
    print(f"median of {args.rounds}; "
          + (f"left {args.base}, right {args.cls}" if args.base else args.cls))
    print_commands(binaries, args)
    if re.search(args.only, "agent"):
        print_agents(binaries, args)


if __name__ == "__main__":
    main()
