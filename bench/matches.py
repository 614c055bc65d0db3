#!/usr/bin/env python3
"""Matches side by side: this build and, optionally, another one.

    bench/matches.py                         build/bin/cls alone
    bench/matches.py --base OTHER/bin/cls    alternating with another build

Prints a table, medians over the rounds:
    cycles/s    of the match
    CPU s       of all processes: cls, servers and Playmakers
    of cls      CPU seconds of cls itself, with its agents, its mocks and the embedded server
    server      CPU seconds of rcssserver; 0: the server is embedded
    peak MB     memory of the largest process
    reply us    time in which half of the decisions of the right side were received
Unless the row says how they are asked, mocks are called as functions, without gRPC. Matches with
Python are a third as long. A build without `--batch` asks each agent in every row. Then cycles per
second and CPU time of gRPC alone, with the smallest Playmaker (rpc_ceiling of cls_bench beside the
binary), and which share of it matches reach. Environment, each optional:
    CLS_BENCH_BASE      as --base
    CLS_BENCH_CYCLES    as --cycles
    CLS_RCSSSERVER      rcssserver, else the one in PATH
    CLS_BENCH_TEAMS     folders of two teams with start.sh, with a space between them
    CLS_UPSTREAM_PYTHON command of a Playmaker of the upstream project, with {port}:
                        "cd sample && python3 server.py --rpc-port {port}"
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEAD = f"{'cycles/s':>9} {'CPU s':>7} {'of cls':>7} {'server':>7} {'peak MB':>8} {'reply us':>9}"
NAME_WIDTH = 54
SIMPLE = "mock:simple"  # plays the same in every build
# The row of RPC alone that bounds a match: the same transport and calls.
LIMITED_BY = {
    "RPC alone, in process, a call per agent": f"{SIMPLE} both, a call per agent",
    "RPC alone, in process, lean States": f"{SIMPLE} both, one call per team",
}


class Skipped(Exception):
    """Why a row has no figures."""


def options():
    parser = argparse.ArgumentParser(description="Matches of two builds, side by side.")
    parser.add_argument("--cls", default=str(ROOT / "build/bin/cls"), help="binary to measure")
    parser.add_argument("--base", default=os.environ.get("CLS_BENCH_BASE", ""),
                        help="binary to compare with")
    parser.add_argument("--cycles", type=int, default=os.environ.get("CLS_BENCH_CYCLES", "6000"),
                        help="length of each match (default: 6000)")
    parser.add_argument("--rounds", type=int, default=5, help="matches of each row (default: 5)")
    parser.add_argument("--only", default="", help="rows whose name has this regular expression")
    return parser.parse_args()


def rows():
    """Name, arguments of `cls match`, and the reason why the row is skipped, if it is."""
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    example = (f"run:PYTHONPATH='{ROOT}/build/python' {python} '{ROOT}/examples/python/playmaker.py'"
               " --port {port}")
    has_grpc = subprocess.run([python, "-c", "import grpc, google.protobuf"],
                              stderr=subprocess.DEVNULL, check=False).returncode == 0
    no_grpc = None if has_grpc else "no Python with grpc"
    sample = os.environ.get("CLS_UPSTREAM_PYTHON")
    server = os.environ.get("CLS_RCSSSERVER") or shutil.which("rcssserver")
    yield f"{SIMPLE} both", [SIMPLE, SIMPLE], None
    yield f"{SIMPLE} both, watched", [SIMPLE, SIMPLE, "--watch"], None
    yield f"{SIMPLE} both, one call per team", [SIMPLE, SIMPLE, "--batch", "always"], None
    yield f"{SIMPLE} both, a call per agent", [SIMPLE, SIMPLE, "--batch", "never"], None
    yield "mock:planner both", ["mock:planner", "mock:planner"], None
    yield ("mock:planner both, a call per agent",
           ["mock:planner", "mock:planner", "--batch", "never"], None)
    yield f"{SIMPLE}, Python example", [SIMPLE, example], no_grpc
    yield (f"{SIMPLE}, Python example, a call per agent", [SIMPLE, example, "--batch", "never"],
           no_grpc)
    yield (f"{SIMPLE}, upstream Python sample", [SIMPLE, f"run:{sample}"],
           None if sample else "CLS_UPSTREAM_PYTHON is not set")
    no_server = None if server else "no rcssserver"
    yield f"{SIMPLE} both on rcssserver", [SIMPLE, SIMPLE, "--server", server or ""], no_server
    yield ("mock:planner both on rcssserver",
           ["mock:planner", "mock:planner", "--server", server or ""], no_server)
    teams = [f"team:{folder}" for folder in os.environ.get("CLS_BENCH_TEAMS", "").split()]
    no_teams = None if len(teams) == 2 else "CLS_BENCH_TEAMS is not set"
    yield "teams on the embedded server", teams, no_teams
    yield "teams on rcssserver", [*teams, "--server", server or ""], no_teams or no_server


def known_arguments(binary, arguments):
    """The arguments for `cls match` of this build; None if it is older and lacks one that matters."""
    help_text = subprocess.run([binary, "match", "--help"], capture_output=True, text=True,
                               check=True).stdout
    if "--batch" in arguments and "--batch" not in help_text:
        place = arguments.index("--batch")
        arguments = arguments[:place] + arguments[place + 2:]
    unknown = [word for word in arguments if word.startswith("--") and word not in help_text]
    return None if unknown else arguments


def watch(program):
    """Returns what cls prints; meanwhile reads the stream of --watch to its end, as its page does."""
    lines = []
    for line in program.stderr:
        lines.append(line)
        address = re.search(rb"http://\S+", line)
        if address:
            reader = threading.Thread(target=read_all, args=(address.group().decode() + "live",))
            reader.start()
    return b"".join(lines)


def read_all(url):
    with urllib.request.urlopen(url) as stream:
        while stream.read(1 << 16):
            pass


def match(binary, arguments, cycles):
    """The figures of one match, in the order of HEAD."""
    with tempfile.TemporaryDirectory() as folder:
        command = [binary, "match", *arguments, "--seed", "7", "--cycles", str(cycles), "--json",
                   "--quiet", "--dir", os.path.join(folder, "match")]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
            errors = watch(program)
            text = program.stdout.read()
            _, status, usage = os.wait4(program.pid, 0)  # its processes included
            program.returncode = os.waitstatus_to_exitcode(status)
    if program.returncode != 0:
        lines = errors.decode(errors="replace").strip().splitlines() or ["no message"]
        raise Skipped(lines[-1])
    result = json.loads(text)
    cpu = usage.ru_utime + usage.ru_stime
    others = sum(process["cpu_seconds"] for process in result["processes"])
    replies = [player["rpc_us"]["p50"] for player in result["right"]["players"]
               if "rpc_us" in player] or [0.0]  # none of a team of programs
    return (result["cycles_per_second"], cpu, cpu - others, result["server"]["cpu_seconds"] or 0.0,
            usage.ru_maxrss / 1024, statistics.median(replies))


def measure(arguments_of, args):
    """Medians for each binary of `arguments_of`; the binaries take turns."""
    figures = {binary: [] for binary in arguments_of}
    for _ in range(args.rounds):
        for binary, arguments in arguments_of.items():
            is_python = any(word.startswith("run:") for word in arguments)
            cycles = max(args.cycles // 3, 1) if is_python else args.cycles
            figures[binary].append(match(binary, arguments, cycles))
    return {binary: [statistics.median(column) for column in zip(*values)]
            for binary, values in figures.items()}


def cell(figures):
    if not figures:
        return f"{'-':>{len(HEAD)}}"
    return "{:9.0f} {:7.1f} {:7.1f} {:7.1f} {:8.0f} {:9.0f}".format(*figures)


def ratio(figures, binaries):
    """How many times as many cycles a second the second build plays."""
    if len(binaries) < 2 or not all(figures.get(binary) for binary in binaries):
        return ""
    return f" | {figures[binaries[1]][0] / figures[binaries[0]][0]:5.2f} x"


def print_row(name, figures, binaries):
    cells = "".join(" |" + cell(figures.get(binary)) for binary in binaries)
    print(f"{name:{NAME_WIDTH}}{cells}{ratio(figures, binaries)}", flush=True)


def ceiling_name(benchmark):
    """The row of a benchmark such as rpc_ceiling/transport:0/threads:2/asking:1/..."""
    transports = ("in process", "TCP", "Unix socket")
    asking = ("a call per agent", "one call per team", "lean States")
    values = dict(part.split(":") for part in benchmark.split("/") if ":" in part)
    return (f"RPC alone, {transports[int(values['transport'])]}, "
            f"{asking[int(values.get('asking', 0))]}")


def ceilings(binary):
    """Cycles/s and CPU seconds of 6000 cycles of RPC alone, by row."""
    bench = os.path.join(os.path.dirname(binary), "cls_bench")
    if not os.path.exists(bench):
        return {}
    text = subprocess.run([bench, "--benchmark_filter=^rpc_ceiling/.*threads:2",
                           "--benchmark_format=json"], capture_output=True, text=True,
                          check=True).stdout
    return {ceiling_name(run["name"]): (run["cycles_per_second"], run["cpu_us_per_cycle"] * 6e-3)
            for run in json.loads(text)["benchmarks"]}


def print_ceilings(binaries, args, played):
    """`played`: the figures of the rows of matches, by name and binary."""
    found = {}  # figures by row and binary
    for _ in range(args.rounds):
        for binary in binaries:
            for name, figures in ceilings(binary).items():
                found.setdefault(name, {}).setdefault(binary, []).append(figures)
    for name, by_binary in found.items():
        medians = {binary: [statistics.median(column) for column in zip(*values)]
                   for binary, values in by_binary.items()}
        cells = "".join(f" |{'-':>{len(HEAD)}}" if binary not in medians else
                        f" |{{:9.0f}} {{:7.1f}}{'':{len(HEAD) - 17}}".format(*medians[binary])
                        for binary in binaries)
        print(f"{name:{NAME_WIDTH}}{cells}{ratio(medians, binaries)}", flush=True)
        match_name = LIMITED_BY.get(name)
        if match_name in played:
            print_share(match_name, played[match_name], medians, binaries)
    if found:
        print("(CPU s of RPC alone: for 6000 cycles)")


def print_share(name, played, ceiling, binaries):
    """The cycles/s of a match as a share of what RPC alone reaches."""
    cells = "".join(f" |{played[binary][0] / ceiling[binary][0]:9.0%}{'':{len(HEAD) - 9}}"
                    if binary in played and binary in ceiling else f" |{'-':>{len(HEAD)}}"
                    for binary in binaries)
    print(f"{'  share of it: ' + name:{NAME_WIDTH}}{cells}", flush=True)


def main():
    args = options()
    binaries = [args.base, args.cls] if args.base else [args.cls]
    print(f"{args.cycles} cycles, median of {args.rounds}; "
          + (f"left {args.base}, right {args.cls}" if args.base else args.cls))
    print(f"{'match':{NAME_WIDTH}}" + f" |{HEAD}" * len(binaries))
    skipped = []
    played = {}
    for name, arguments, reason in rows():
        if not re.search(args.only, name):
            continue
        try:
            if reason:
                raise Skipped(reason)
            arguments_of = {binary: known_arguments(binary, arguments) for binary in binaries}
            usable = {binary: known for binary, known in arguments_of.items() if known is not None}
            played[name] = measure(usable, args)
            print_row(name, played[name], binaries)
        except Skipped as problem:
            skipped.append(f"skipped: {name}: {problem}")
    if re.search(args.only, "RPC alone"):
        print_ceilings(binaries, args, played)
    print("\n".join(skipped))


if __name__ == "__main__":
    main()
