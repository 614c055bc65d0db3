"""Measures the speed of environments: python3 -m cls_gym.bench [TASK ...]

    python3 -m cls_gym.bench                              the usual tasks, sizes and threads
    python3 -m cls_gym.bench cls/HFO-2v2-v0 --num-envs 64 --actions skills
    python3 -m cls_gym.bench --obs world_model --opponent planner --json

World steps with random actions of a fixed seed, features `ego` and the action set that the examples
train with, masks included: through VectorEnv (`python`) and through the engine alone (`engine`):
calls of the same functions without spaces, copies and infos. `/s` is per second of the wall clock,
`/CPU s` per second of processor time of all threads. The share is what is left of the engine's
speed in Python. Medians over rounds that measure all of it in turn. `reset` is the time of a reset
with its first observation, in microseconds per world.
"""
from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence

import numpy as np

import cls_gym

TASKS = ("cls/HFO-1v0-v0", "cls/HFO-2v2-v0", "cls/Match-v0")


class Case(NamedTuple):
    """What a row of the table measures."""

    task: str
    actions: str
    obs: str
    num_envs: int
    threads: int
    opponent: Optional[str] = None  # the task's


class Speed(NamedTuple):
    """World steps per second."""

    wall: float
    cpu: float


def random_actions(envs: cls_gym.VectorEnv, count: int) -> List[Any]:
    """Batches of random actions."""
    envs.action_space.seed(1)
    return [envs.action_space.sample() for _ in range(count)]


def _timed(work: Callable[[], None], steps: int) -> Speed:
    wall, cpu = time.perf_counter(), time.process_time()
    work()
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    return Speed(steps / wall, steps / max(cpu, 1e-9))


def _python(envs: cls_gym.VectorEnv, actions: List[Any], steps: int) -> Speed:
    def work() -> None:
        for number in range(steps):
            envs.step(actions[number % len(actions)])
    return _timed(work, steps * envs.num_envs)


def _engine(envs: cls_gym.VectorEnv, actions: List[Any], steps: int) -> Speed:
    """The engine with the same actions, which its buffers take without checks."""
    worlds = envs._worlds  # noqa: SLF001
    pool, targets = worlds.pool, []
    for action in actions:
        worlds.set_actions(action)
        targets.append((pool.action_ids.copy(), pool.action_values.copy()))

    def work() -> None:
        for number in range(steps):
            ids, values = targets[number % len(targets)]
            pool.action_ids[...] = ids
            if values.size:
                pool.action_values[...] = values
            pool.step()
    return _timed(work, steps * envs.num_envs)


def _reset(envs: cls_gym.VectorEnv, count: int) -> float:
    """Seconds of a reset of all worlds."""
    pool = envs._worlds.pool  # noqa: SLF001
    seeds = np.arange(envs.num_envs, dtype=np.uint64)
    start = time.perf_counter()
    for _ in range(count):
        pool.reset(None, seeds)
        seeds += np.uint64(envs.num_envs)
    return (time.perf_counter() - start) / count


def measure(case: Case, rounds: int, seconds: float) -> Dict[str, Any]:
    """One row of the table."""
    opponent: Dict[str, Any] = {} if case.opponent is None else {"opponent": case.opponent}
    envs = cls_gym.VectorEnv(case.task, case.num_envs, obs=case.obs, threads=case.threads,
                             features="ego", actions=case.actions, autoreset_mode="same_step",
                             **opponent)
    actions = random_actions(envs, 64)
    envs.reset(seed=1)
    speed, steps = _python(envs, actions, 8), 8
    while steps * case.num_envs / speed.wall < seconds / 4:  # also warms up
        steps *= 2
        speed = _python(envs, actions, steps)
    steps = max(1, int(speed.wall * seconds / case.num_envs))
    python, engine, resets = [], [], []
    for _ in range(rounds):
        envs.reset(seed=1)  # both play the same cycles
        python.append(_python(envs, actions, steps))
        envs.reset(seed=1)
        engine.append(_engine(envs, actions, steps))
        resets.append(1e6 * _reset(envs, 10) / case.num_envs)
    agents = len(envs.spec_of_task.agents)
    envs.close()
    return {**case._asdict(), "agents": agents,
            "python": statistics.median(one.wall for one in python),
            "python_cpu": statistics.median(one.cpu for one in python),
            "engine": statistics.median(one.wall for one in engine),
            "engine_cpu": statistics.median(one.cpu for one in engine),
            "reset_us": statistics.median(resets),
            "share": statistics.median(p.wall / e.wall for p, e in zip(python, engine))}


def _head() -> str:
    return (f"{'task':<18} {'actions':<12} {'N':>4} {'T':>2} {'python/s':>10} {'/CPU s':>10} "
            f"{'engine/s':>10} {'/CPU s':>10} {'share':>6} {'reset':>6}")


def _line(row: Dict[str, Any]) -> str:
    return (f"{row['task']:<18} {row['actions']:<12} {row['num_envs']:>4} {row['threads']:>2} "
            f"{row['python']:>10.0f} {row['python_cpu']:>10.0f} {row['engine']:>10.0f} "
            f"{row['engine_cpu']:>10.0f} {row['share']:>6.2f} {row['reset_us']:>6.1f}")


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python3 -m cls_gym.bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tasks", nargs="*", metavar="TASK", default=list(TASKS),
                        help=f"ids (default: {' '.join(TASKS)})")
    parser.add_argument("--actions", default="low_discrete", metavar="SET",
                        help="action set (default: low_discrete, with masks)")
    parser.add_argument("--obs", choices=("full_state", "world_model"), default="full_state",
                        help="what agents know (default: full_state)")
    parser.add_argument("--opponent", metavar="WHO",
                        help="who plays the other team, such as planner (default: the task's)")
    parser.add_argument("--num-envs", type=int, nargs="+", default=[1, 64, 1024], metavar="N",
                        help="numbers of worlds (default: 1 64 1024)")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], metavar="T",
                        help="numbers of threads; no more than worlds (default: 1 2)")
    parser.add_argument("--rounds", type=int, default=5, metavar="N")
    parser.add_argument("--seconds", type=float, default=0.3, metavar="S",
                        help="of each measurement (default: 0.3)")
    parser.add_argument("--json", action="store_true", help="print a JSON document")
    return parser.parse_args(arguments)


def main(arguments: Sequence[str]) -> int:
    options = _options(arguments)
    cases = [Case(task, options.actions, options.obs, num_envs, threads, options.opponent)
             for task in options.tasks for num_envs in options.num_envs
             for threads in options.threads if threads <= num_envs]
    rows = []
    if not options.json:
        print(_head())
    for case in cases:
        rows.append(measure(case, options.rounds, options.seconds))
        if not options.json:
            print(_line(rows[-1]), flush=True)
    if options.json:
        json.dump({"schema": "cls.training.bench/1", "rows": rows}, sys.stdout, indent=2)
        print()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (cls_gym.EngineError, ImportError) as error:
        sys.exit(f"cls_gym.bench: {error}")
