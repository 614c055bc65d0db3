"""Episodes as files for offline learning: Arrow tables, one file an episode.

>>> import cls_gym, cls_gym.data, numpy, os
>>> envs = cls_gym.VectorEnv("cls/HFO-1v0-v0", 8, features="ego", actions="skills", max_cycles=20,
...                          autoreset_mode="disabled")
>>> def policy(observations, masks):  # rows of all agents of all worlds
...     return masks.argmax(axis=1)
>>> cls_gym.data.record(envs, policy, episodes=10, out="episodes")
10
>>> sorted(os.listdir("episodes"))[:2]
['00000000.arrow', '00000001.arrow']
>>> episode = cls_gym.data.load("episodes/00000003.arrow")
>>> episode["observation"].shape[1:], episode["action"].dtype
((1, 31), dtype('int32'))

Writing and load() need pyarrow (`pip install pyarrow`); any reader of Arrow's IPC format does.
docs/training.md has lines for polars, pandas and duckdb.
"""
from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Callable, Dict, List, Optional, Union

import numpy as np

from cls_gym._api import AutoresetMode
from cls_gym._config import ConfigError, plain
from cls_gym._engine import fingerprint
from cls_gym._files import replaced
from cls_gym.adapters._common import check_vector
from cls_gym.policy import Policy
from cls_gym.vector import VectorEnv

#: Ids int64[rows], or numbers float32[rows, V], of observations [rows, F] and masks [rows, K].
Act = Callable[[np.ndarray, np.ndarray], np.ndarray]
SCHEMA = "cls.episodes/1"
_SUFFIX = ".arrow"
#: Columns of one agent after the other; the last row of an episode has those of `_LAST` alone.
_LAST = ("observation", "state")


def _arrow() -> Any:
    try:
        import pyarrow
        import pyarrow.ipc
    except ImportError as error:
        raise ImportError("cls_gym.data needs pyarrow: pip install pyarrow") from error
    return pyarrow


def record(envs: VectorEnv, policy: Union[Policy, Act], episodes: int,
           out: Union[str, os.PathLike[str]], *, seed: int = 0, first: int = 0,
           expert: Union[Policy, Act, None] = None) -> int:
    """Plays episodes `first` to `first + episodes - 1` and writes each into the folder `out`, as
    NUMBER.arrow; returns how many were written. Episode k starts with reset(seed=seed + k), so that
    it does not depend on the number of worlds. Files that are there stay: after an interruption
    the same call plays the rest. A file appears when it is complete.

    envs: a VectorEnv with autoreset_mode="disabled", mask="info" and actions that are no tuples.
    expert: another policy whose actions are noted in the column `expert`, for imitation.
    """
    arrow = _arrow()
    check_vector(envs, "record()", AutoresetMode.DISABLED)
    if envs._worlds.mask_place not in (None, "info"):
        raise ConfigError("mask: record() has a column of its own; use \"info\"")
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    waiting = [number for number in range(first, first + episodes)
               if not (folder / f"{number:08d}{_SUFFIX}").exists()]
    written, acts = len(waiting), [_act(policy), *([_act(expert)] if expert is not None else [])]
    running: List[Optional[_Episode]] = [None] * envs.num_envs
    _begin(envs, running, waiting, seed)
    while any(running):
        _step(envs, running, acts)
        for world, episode in enumerate(running):
            if episode is not None and episode.over:
                episode.write(arrow, folder, envs)
                running[world] = None
        if waiting or any(running):
            _begin(envs, running, waiting, seed)
    return written


def _act(policy: Union[Policy, Act]) -> Act:
    return policy.act if isinstance(policy, Policy) else policy


class _Episode:
    """Rows of an episode that is being played."""

    def __init__(self, number: int, seed: int) -> None:
        self.number, self.seed = number, seed
        self.rows: Dict[str, List[np.ndarray]] = {}
        self.over = False
        self.status = 0

    def add(self, **values: Any) -> None:
        for name, value in values.items():
            self.rows.setdefault(name, []).append(np.array(value))

    def write(self, arrow: Any, folder: pathlib.Path, envs: VectorEnv) -> None:
        count = len(self.rows["observation"])
        columns = {name: _column(arrow, values, count) for name, values in self.rows.items()}
        task, _, keywords, *_ = envs._worlds._arguments
        spec = {key: value for key, value in envs.spec_of_task.document.items()
                if key not in ("num_envs", "threads", "autoreset")}
        about = {"schema": SCHEMA, "task": task, "keywords": plain(keywords, "keywords"),
                 "spec": spec, "seed": self.seed, "episode": self.number, "engine": fingerprint(),
                 "status": envs.spec_of_task.statuses[self.status]}
        table = arrow.table(columns).replace_schema_metadata({"cls": json.dumps(about)})
        with replaced(folder / f"{self.number:08d}{_SUFFIX}") as partial, \
                arrow.OSFile(str(partial), "wb") as sink, \
                arrow.ipc.new_file(sink, table.schema) as writer:
            writer.write_table(table)


def _column(arrow: Any, values: List[np.ndarray], count: int) -> Any:
    """Rows of numbers as a column, lists of one size where they are arrays; null where they end
    before the episode's last observation."""
    rows = np.stack(values)
    missing = count - len(rows)
    flat = arrow.array(rows.reshape(-1))
    if rows.ndim > 1:
        size = rows[0].size
        kind = arrow.list_(flat.type, size)
        column = arrow.FixedSizeListArray.from_arrays(flat, size)
        flat = column.cast(kind)
    return arrow.concat_arrays([flat, arrow.nulls(missing, flat.type)]) if missing else flat


def _begin(envs: VectorEnv, running: List[Optional[_Episode]], waiting: List[int], seed: int
           ) -> None:
    """Starts the next episodes in worlds without one. The first call starts all worlds; those
    without an episode play anything."""
    free = [world for world, episode in enumerate(running) if episode is None]
    if not free:
        return
    fresh = len(free) == envs.num_envs
    seeds: List[Optional[int]] = [None] * envs.num_envs
    for world in free:
        if waiting:
            number = waiting.pop(0)
            running[world] = _Episode(number, seed + number)
        own = running[world]
        seeds[world] = seed + own.number if own is not None else 0
    which = np.zeros(envs.num_envs, np.bool_)
    which[free] = True
    envs.reset(seed=seeds, options={} if fresh else {"reset_mask": which})
    _observe(envs, running, which)


def _observe(envs: VectorEnv, running: List[Optional[_Episode]], which: Any) -> None:
    worlds = envs._worlds
    for world in np.flatnonzero(which):
        episode = running[world]
        if episode is not None:
            episode.add(observation=worlds.pool.observations[world], state=worlds.pool.state[world])


def _step(envs: VectorEnv, running: List[Optional[_Episode]], acts: List[Act]) -> None:
    pool, ids = envs._worlds.pool, bool(envs.spec_of_task.actions.names)
    seen = pool.observations.reshape(envs.num_envs * envs.num_agents, -1).copy()
    masks = pool.action_masks.reshape(len(seen), -1).copy()
    played, *others = [np.asarray(act(seen, masks)).reshape(
        envs.num_envs, envs.num_agents, *(() if ids else (-1,))) for act in acts]
    kind = np.int32 if ids else np.float32
    for world, episode in enumerate(running):
        if episode is not None:
            episode.add(action=played[world].astype(kind))
            if ids:
                episode.add(mask=pool.action_masks[world])
            if others:
                episode.add(expert=others[0][world].astype(kind))
    _, _, terminated, truncated, infos = envs.step(played if envs.num_agents > 1 else played[:, 0])
    for world, episode in enumerate(running):
        if episode is not None:
            episode.add(reward=pool.rewards[world], terminated=terminated[world],
                        truncated=truncated[world])
            episode.over = bool(terminated[world] or truncated[world])
            episode.status = int(infos["status"][world])
    _observe(envs, running, np.ones(envs.num_envs, np.bool_))
    idle = np.array([one is None for one in running]) & (terminated | truncated)
    if idle.any():  # a world that plays anything
        envs.reset(options={"reset_mask": idle})


def load(path: Union[str, os.PathLike[str]]) -> Dict[str, Any]:
    """An episode of T steps: `observation` float32[T + 1, A, F], `state` float32[T + 1, S],
    `action` int32[T, A] or float32[T, A, V], `mask` int8[T, A, K], `reward` float32[T, A],
    `terminated` and `truncated` bool[T], `expert` as `action`, and `about`: the metadata."""
    arrow = _arrow()
    with arrow.memory_map(os.fspath(path)) as source:
        table = arrow.ipc.open_file(source).read_all()
    about = json.loads(table.schema.metadata[b"cls"])
    agents, steps = about["spec"]["num_agents"], table.num_rows - 1
    ids = about["spec"]["actions"]["ids"]
    result: Dict[str, Any] = {"about": about}
    for name in table.column_names:
        column = table.column(name).combine_chunks()
        count = steps + (name in _LAST)
        part = column.slice(0, count)
        if arrow.types.is_fixed_size_list(column.type):
            rows = part.flatten().to_numpy(zero_copy_only=False).reshape(count, -1)
            if name != "state":
                rows = rows.reshape(count, agents, -1)
            if name == "reward" or (name in ("action", "expert") and ids):
                rows = rows[..., 0]
            result[name] = rows
        else:
            result[name] = part.to_numpy(zero_copy_only=False)
    return result


def files(folder: Union[str, os.PathLike[str]]) -> List[pathlib.Path]:
    """The episodes of a folder, by number."""
    return sorted(pathlib.Path(folder).glob(f"*{_SUFFIX}"))


def to_minari(folder: Union[str, os.PathLike[str]], dataset_id: str, **about: Any) -> Any:
    """A dataset of Minari from recorded episodes, such as "cls/hfo-2v2/planner-v0"; actions of
    several agents are joint ones of one environment, rewards the mean over the agents. `about`:
    what create_dataset_from_buffers() takes, such as author and description. Needs minari."""
    import minari
    from minari.data_collector import EpisodeBuffer

    episodes = [load(path) for path in files(folder)]
    if not episodes:
        raise ConfigError(f"to_minari: no episodes in {os.fspath(folder)!r}")
    first = episodes[0]["about"]
    if any(one["about"]["keywords"] != first["keywords"] for one in episodes):
        raise ConfigError(f"to_minari: episodes of several environments in {os.fspath(folder)!r}")
    import gymnasium
    name = first["task"] if first["task"].startswith("cls/") else f"cls/{first['task']}"
    env = gymnasium.make(name, **first["keywords"])
    buffers = [EpisodeBuffer(id=number, **_joint(one)) for number, one in enumerate(episodes)]
    dataset = minari.create_dataset_from_buffers(dataset_id, buffers, env=env, **about)
    env.close()
    return dataset


def _joint(episode: Dict[str, Any]) -> Dict[str, Any]:
    """What an Env returns and takes: of one agent without, of several with a row for each."""
    alone: Any = (slice(None), 0) if episode["observation"].shape[1] == 1 else slice(None)
    ids = episode["action"].dtype == np.int32
    return {"seed": episode["about"]["seed"], "observations": episode["observation"][alone],
            "actions": episode["action"][alone].astype(np.int64 if ids else np.float32),
            "rewards": episode["reward"].mean(axis=1).astype(np.float64),
            "terminations": episode["terminated"], "truncations": episode["truncated"]}
