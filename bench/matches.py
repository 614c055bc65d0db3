#!/usr/bin/env python3
"""Matches side by side: this build and, optionally, another one.

    bench/matches.py                         build/bin/cls alone
    bench/matches.py --base OTHER/bin/cls    alternating with another build

Prints a table: cycles per second, CPU seconds (cls, servers and Playmakers together) and peak memory
of the largest process; medians over the rounds. Environment, each optional:
    CLS_BENCH_BASE      as --base
    CLS_BENCH_CYCLES    as --cycles
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
    parser.add_argument("--only", default="", help="rows whose name contains this")
    return parser.parse_args()


def rows():
    """Name and arguments of `cls match`, or the reason why there are none."""
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    example = (f"run:PYTHONPATH='{ROOT}/build/python' {python} '{ROOT}/examples/python/playmaker.py'"
               " --port {port}")
    has_grpc = subprocess.run([python, "-c", "import grpc, google.protobuf"],
                              stderr=subprocess.DEVNULL, check=False).returncode == 0
    no_grpc = None if has_grpc else "no Python with grpc"
    sample = os.environ.get("CLS_UPSTREAM_PYTHON")
    server = os.environ.get("CLS_RCSSSERVER") or shutil.which("rcssserver")
    yield "mock mock", ["mock", "mock"], None
    yield "mock mock, watched", ["mock", "mock", "--watch"], None
    yield "mock mock, one call per team", ["mock", "mock", "--batch", "always"], None
    yield "mock mock, a call per agent", ["mock", "mock", "--batch", "never"], None
    yield "mock:planner both", ["mock:planner", "mock:planner"], None
    yield "mock, Python example", ["mock", example], no_grpc
    yield "the same, a call per agent", ["mock", example, "--batch", "never"], no_grpc
    yield ("mock, upstream Python sample", ["mock", f"run:{sample}"],
           None if sample else "CLS_UPSTREAM_PYTHON is not set")
    yield ("mock mock on rcssserver", ["mock", "mock", "--server", server or ""],
           None if server else "no rcssserver")


def unknown_options(binary, arguments):
    """Those of the arguments that `cls match` of an older build lacks."""
    help_text = subprocess.run([binary, "match", "--help"], capture_output=True, text=True,
                               check=True).stdout
    return [word for word in arguments if word.startswith("--") and word not in help_text]


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
    """One match: cycles/s, CPU seconds, peak MB."""
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
    return (json.loads(text)["cycles_per_second"], usage.ru_utime + usage.ru_stime,
            usage.ru_maxrss / 1024)


def measure(binaries, arguments, args):
    """Medians for each binary; the binaries take turns."""
    figures = {binary: [] for binary in binaries}
    for _ in range(args.rounds):
        for binary in binaries:
            figures[binary].append(match(binary, arguments, args.cycles))
    return {binary: [statistics.median(column) for column in zip(*values)]
            for binary, values in figures.items()}


def cell(figures):
    return f"{figures[0]:9.0f} {figures[1]:8.1f} {figures[2]:8.0f}" if figures else f"{'-':>27}"


def print_row(name, figures, binaries):
    line = f"{name:30}" + "".join(" |" + cell(figures.get(binary)) for binary in binaries)
    if len(binaries) == 2 and all(figures.get(binary) for binary in binaries):
        line += f" | {figures[binaries[1]][0] / figures[binaries[0]][0]:5.2f} x"
    print(line, flush=True)


def ceilings(binary, rounds):
    """Median cycles/s and CPU µs per cycle of RPC alone, by benchmark name."""
    bench = os.path.join(os.path.dirname(binary), "cls_bench")
    if not os.path.exists(bench):
        return {}
    text = subprocess.run([bench, "--benchmark_filter=^rpc_ceiling/.*threads:2", "--benchmark_format=json",
                           f"--benchmark_repetitions={rounds}"], capture_output=True, text=True,
                          check=True).stdout
    found = {}
    for run in json.loads(text)["benchmarks"]:
        if run.get("run_type") == "iteration":
            found.setdefault(run["name"], []).append(
                (run["cycles_per_second"], run["cpu_us_per_cycle"]))
    return {name: [statistics.median(column) for column in zip(*values)]
            for name, values in found.items()}


def print_ceilings(binaries, args):
    transports = ("in process", "TCP", "Unix socket")
    asking = ("a call per agent", "one call per team", "the same, lean States")
    by_binary = {binary: ceilings(binary, args.rounds) for binary in binaries}
    names = list(dict.fromkeys(name for found in by_binary.values() for name in found))
    for name in names:
        values = dict(part.split(":") for part in name.split("/") if ":" in part)
        title = (f"RPC alone, {transports[int(values['transport'])]}, "
                 f"{asking[int(values.get('asking', 0))]}")
        cells = [f"{found[name][0]:6.0f} cycles/s, {found[name][1]:6.0f} us CPU a cycle"
                 if name in found else "-" for found in by_binary.values()]
        print(f"{title:48} {' | '.join(cells)}", flush=True)


def main():
    args = options()
    binaries = [args.base, args.cls] if args.base else [args.cls]
    print(f"{args.cycles} cycles, median of {args.rounds}; "
          + (f"left {args.base}, right {args.cls}" if args.base else args.cls))
    print(f"{'match':30}" + f" |{'cycles/s':>9} {'CPU s':>8} {'peak MB':>8}" * len(binaries))
    skipped = []
    for name, arguments, reason in rows():
        if args.only not in name:
            continue
        usable = [one for one in binaries if not unknown_options(one, arguments)]
        try:
            if reason:
                raise Skipped(reason)
            print_row(name, measure(usable, arguments, args), binaries)
        except Skipped as problem:
            skipped.append(f"skipped: {name}: {problem}")
    if not args.only or args.only in "RPC alone":
        print_ceilings(binaries, args)
    print("\n".join(skipped))


if __name__ == "__main__":
    main()
