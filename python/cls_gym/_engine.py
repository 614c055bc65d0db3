"""The C interface of the engine (training/c_api/cls_training.h) over ctypes."""
from __future__ import annotations

import ctypes
import functools
import hashlib
import json
import os
import pathlib
import weakref
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from cls_gym._config import (ActionError, ConfigError, EngineError, check_choice, plain,
                             readable)
from cls_gym.spec import ActionSet, Feature, Sense, Spec

LIBRARY = "libcls_training.so"
VARIABLE = "CLS_TRAINING_LIBRARY"
ABI = 4

_SMALL_BUFFER = -9


_EXCEPTIONS: Dict[int, Callable[[str], Exception]] = {-3: ConfigError, -6: ActionError,
                                                      -8: OSError}


class _Buffer(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("count", ctypes.c_uint64)]


# The arrays of a pool in the order of cls_training_buffers: element type, and a shape of N worlds,
# A agents (I: where the action set has ids; H senses add [1 + H]), F features, K ids, V values, S state features,
# R reward terms, 2 teams. training/pool/arrays.inc is the table of the engine.
_ARRAYS: Dict[str, Tuple[type, str]] = {
    "action_ids": (np.int32, "NI"), "action_values": (np.float32, "NAV"),
    "next_seeds": (np.uint64, "N"), "observations": (np.float32, "NAF"),
    "rewards": (np.float32, "NA"), "terminated": (np.bool_, "N"), "truncated": (np.bool_, "N"),
    "status": (np.int32, "N"), "alive": (np.bool_, "NA"), "action_masks": (np.int8, "NAK"),
    "state": (np.float32, "NS"), "reward_terms": (np.float32, "NR"),
    "final_observations": (np.float32, "NAF"), "final_state": (np.float32, "NS"),
    "was_reset": (np.bool_, "N"), "cycles": (np.int32, "N"), "score": (np.int32, "N2"),
    "illegal": (np.int32, "NA"), "seeds": (np.uint64, "N"), "opponent": (np.int32, "N"),
    "expert": (np.int32, "NE")}
_INPUTS = ("action_ids", "action_values", "next_seeds")


class _Buffers(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_uint64)] + [(name, _Buffer) for name in _ARRAYS]


class _Player(ctypes.Structure):
    _fields_ = [("side", ctypes.c_int32), ("unum", ctypes.c_int32), ("on_pitch", ctypes.c_int32),
                ("goalie", ctypes.c_int32)] + [(name, ctypes.c_double) for name in (
                    "x", "y", "vx", "vy", "body", "neck", "stamina", "kickable_area", "effort",
                    "recovery", "capacity")] + [(name, ctypes.c_int32) for name in (
                        "tackle_cycles", "foul_cycles", "catch_ban", "cards", "type", "reserved")]


class World(ctypes.Structure):
    """The physical state of a world, whose members can be changed (cls_training_world).

    seed; cycle of the episode; time of the match clock; score[2] (left, right); status; play_mode
    (bytes: b"play_on"); ball_x, ball_y, ball_vx, ball_vy; last_touch and catcher, indices of players
    or -1; players[22], left 1 to 11, right 1 to 11: side (1 left, -1 right), unum, on_pitch, goalie,
    x, y, vx, vy, body, neck (relative to the body), stamina, kickable_area, effort, recovery,
    capacity, tackle_cycles, foul_cycles, catch_ban, cards, type. Meters, meters a cycle and degrees; the
    left team defends x = -52.5, y grows downwards. copy.copy() gives another one.
    """

    _fields_ = [("struct_size", ctypes.c_uint64), ("seed", ctypes.c_uint64),
                ("cycle", ctypes.c_int32), ("time", ctypes.c_int32),
                ("score", ctypes.c_int32 * 2), ("status", ctypes.c_int32),
                ("play_mode", ctypes.c_char * 32), ("ball_x", ctypes.c_double),
                ("ball_y", ctypes.c_double), ("ball_vx", ctypes.c_double),
                ("ball_vy", ctypes.c_double), ("last_touch", ctypes.c_int32),
                ("catcher", ctypes.c_int32), ("players", _Player * 22)]


_POOL = ctypes.c_uint64
_SIZE = ctypes.POINTER(ctypes.c_size_t)
_FUNCTIONS: Dict[str, List[Any]] = {
    "catalog": [ctypes.c_char_p, ctypes.c_size_t, _SIZE],
    "create": [ctypes.c_char_p, ctypes.POINTER(_POOL)],
    "spec": [_POOL, ctypes.c_char_p, ctypes.c_size_t, _SIZE],
    "close": [_POOL],
    "bind": [_POOL, ctypes.POINTER(_Buffers)],
    "reset": [_POOL, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64],
    "step": [_POOL],
    "set_options": [_POOL, ctypes.c_int64, ctypes.c_char_p],
    "snapshot": [_POOL, ctypes.c_uint64, ctypes.POINTER(ctypes.c_uint64)],
    "restore": [_POOL, ctypes.c_uint64, ctypes.c_uint64],
    "release": [_POOL, ctypes.c_uint64],
    "fork": [_POOL, ctypes.c_uint64, ctypes.c_uint64],
    "record": [_POOL, ctypes.c_uint64, ctypes.c_char_p],
    "view": [_POOL, ctypes.c_uint64, ctypes.POINTER(World)],
    "set_state": [_POOL, ctypes.c_uint64, ctypes.POINTER(World)],
}


def library_path() -> pathlib.Path:
    """The engine: $CLS_TRAINING_LIBRARY, beside this file (wheel), or in the build tree."""
    if os.environ.get(VARIABLE):
        return pathlib.Path(os.environ[VARIABLE])
    here = pathlib.Path(__file__).resolve().parent
    # build/python/cls_gym -> build/lib; python/cls_gym of a checkout -> build/lib
    places = [here / LIBRARY, here.parents[1] / "lib" / LIBRARY,
              here.parents[1] / "build" / "lib" / LIBRARY]
    for place in places:
        if place.is_file():
            return place
    raise ImportError(f"cls_gym: no {LIBRARY} in {', '.join(str(p.parent) for p in places)}; "
                      "./bootstrap python in the checkout of cls builds it and makes an environment "
                      f"with it, or {VARIABLE} names its path")


@functools.lru_cache(maxsize=None)
def library() -> Any:
    """The loaded engine. Raises ImportError if there is none or its interface is another."""
    path = library_path()
    try:
        loaded = ctypes.CDLL(str(path))
        version = loaded.cls_training_abi()
    except (OSError, AttributeError) as error:
        raise ImportError(f"cls_gym: cannot load {path}: {error}") from error
    loaded.cls_training_error.restype = ctypes.c_char_p
    if version == 0:
        raise ImportError(f"cls_gym: cannot use {path}: "
                          f"{loaded.cls_training_error().decode('utf-8', 'replace')}; install the "
                          "wheel again, or let TMPDIR name a folder for programs")
    if version != ABI:
        raise ImportError(f"cls_gym: {path} has interface {version}, this package needs {ABI}; "
                          "build both from the same commit")
    loaded.cls_training_version.restype = ctypes.c_char_p
    for name, arguments in _FUNCTIONS.items():
        getattr(loaded, "cls_training_" + name).argtypes = arguments
    return loaded


def _check(code: int) -> None:
    if code:
        text = library().cls_training_error().decode("utf-8", "replace")
        raise _EXCEPTIONS.get(code, EngineError)(text or f"the engine returned {code}")


def _check_text(code: int) -> None:
    """_check() of a call that reads a JSON text of keywords."""
    try:
        _check(code)
    except ConfigError as error:
        raise ConfigError(readable(str(error))) from None


def _document(call: Callable[[Any, int, Any], int]) -> Dict[str, Any]:
    """A JSON document from a function that writes into a buffer."""
    length = ctypes.c_size_t()
    code = call(None, 0, ctypes.byref(length))
    if code != _SMALL_BUFFER:
        _check(code)
    text = ctypes.create_string_buffer(length.value + 1)
    _check(call(text, len(text), ctypes.byref(length)))
    document: Dict[str, Any] = json.loads(text.value.decode("utf-8"))
    return document


@functools.lru_cache(maxsize=None)
def catalog() -> Dict[str, Any]:
    """Everything that can be trained: tasks, feature sets, action sets, reward terms."""
    return _document(library().cls_training_catalog)


def version() -> str:
    """The version of the engine."""
    return str(library().cls_training_version().decode())


@functools.lru_cache(maxsize=None)
def fingerprint() -> str:
    """Version and hash of the engine's file. Two engines with the same one play the same."""
    digest = hashlib.sha256(library_path().read_bytes()).hexdigest()
    return f"{version()} {digest[:16]}"


class Pool:
    """N worlds and their arrays, attributes with the names of _ARRAYS."""

    if TYPE_CHECKING:
        def __getattr__(self, name: str) -> np.ndarray: ...

    def __init__(self, config: Dict[str, Any]) -> None:
        self.config = {key: plain(value, key) for key, value in config.items()}
        handle = ctypes.c_uint64()
        _check_text(library().cls_training_create(json.dumps(self.config).encode(),
                                                  ctypes.byref(handle)))
        self.handle = handle.value
        self.process = os.getpid()
        self.closed = False
        self._free = weakref.finalize(self, library().cls_training_close, self.handle)
        self.spec = _spec(_document(functools.partial(self.call, "spec")))
        self._buffers = _Buffers(struct_size=ctypes.sizeof(_Buffers))
        self._allocate(config["num_envs"])
        self._step = functools.partial(library().cls_training_step, ctypes.c_uint64(self.handle))

    def _allocate(self, n: int) -> None:
        spec, a = self.spec, len(self.spec.agents)
        k = len(spec.actions.names)
        experts = a if spec.document["expert"] != "none" else 0
        sizes = {"N": n, "A": a, "E": experts, "I": a if k else 0, "F": len(spec.features), "K": k,
                 "V": len(spec.actions.values), "S": len(spec.state_features),
                 "R": len(spec.reward_terms), "2": 2}
        arrays: Dict[str, Any] = {name: np.zeros([sizes[one] for one in shape], kind)
                  for name, (kind, shape) in _ARRAYS.items()}
        if spec.actions.senses:
            arrays["action_ids"] = np.zeros([n, a, 1 + len(spec.actions.senses)], np.int32)
        for name in ("final_observations", "final_state"):
            if self.config.get("autoreset") != "same_step":
                setattr(self, name, None)
                del arrays[name]
        for name, array in arrays.items():
            setattr(self, name, array)
        self.bind(**arrays)

    def bind(self, **arrays: Any) -> None:
        """Replaces arrays, by the names of _ARRAYS, by others of the same type and number of
        elements: contiguous and writable NumPy arrays of any shape, or what has DLPack, such as
        tensors in shared or pinned memory. The attributes become views of them."""
        checked = {name: self._fitting(name, value) for name, value in arrays.items()}
        for name, array in checked.items():
            setattr(self, name, array)
            field = getattr(self._buffers, name)
            field.data, field.count = (array.ctypes.data, array.size) if array.size else (None, 0)
        _check(self.call("bind", ctypes.byref(self._buffers)))

    def _fitting(self, name: str, value: Any) -> np.ndarray:
        """`value` as an array in the shape of the one with this name."""
        if name not in _ARRAYS:
            check_choice("bind", name, list(_ARRAYS))
        array = value if isinstance(value, np.ndarray) else np.from_dlpack(value)
        kind, now = np.dtype(_ARRAYS[name][0]), getattr(self, name, None)
        if now is None:  # not allocated yet, or not filled in this mode
            now = array
            if hasattr(self, name):
                raise ConfigError(f"bind: {name} is for autoreset_mode=\"same_step\"")
        if array.dtype != kind or array.size != now.size:
            raise ConfigError(f"bind: {name}: {array.dtype}{list(array.shape)}, must be "
                              f"{kind}{list(now.shape)}")
        if not (array.flags.c_contiguous and array.flags.writeable and array.flags.aligned):
            raise ConfigError(f"bind: {name}: must be contiguous, aligned and writable")
        return array.reshape(now.shape)

    def outputs(self) -> Dict[str, np.ndarray]:
        """The arrays that the engine fills."""
        names = [name for name in _ARRAYS if name not in _INPUTS]
        return {name: getattr(self, name) for name in names if getattr(self, name) is not None}

    def call(self, name: str, *arguments: Any) -> int:
        """A function of the engine for this pool: its code."""
        return int(getattr(library(), "cls_training_" + name)(self.handle, *arguments))

    def reset(self, which: Optional[np.ndarray], seeds: np.ndarray) -> None:
        """Starts an episode with seeds[i] (uint64[N]) where which[i] (bool[N]; None: all)."""
        mask = None if which is None else which.ctypes.data
        _check(self.call("reset", mask, seeds.ctypes.data, len(seeds)))

    def step(self) -> None:
        """One step of each world whose episode has not ended."""
        code = self._step()
        if code:
            _check(code)

    def set_options(self, options: Dict[str, Any], env: int = -1) -> None:
        """Options of the task for the next episodes of a world; -1: of all worlds."""
        document = {key: plain(value, key) for key, value in options.items()}
        _check_text(self.call("set_options", env, json.dumps(document).encode()))

    def snapshot(self, env: int) -> int:
        """A handle of the episode of world `env`: of this pool and this process alone."""
        handle = ctypes.c_uint64()
        _check(self.call("snapshot", env, ctypes.byref(handle)))
        return handle.value

    def restore(self, env: int, handle: int) -> None:
        """Continues in world `env` where a snapshot was taken."""
        _check(self.call("restore", env, handle))

    def release(self, handle: int) -> None:
        """Frees a snapshot."""
        self.call("release", handle)

    def fork(self, source: int, target: int) -> None:
        """Copies the episode of one world into another one."""
        _check(self.call("fork", source, target))

    def record(self, env: int, path: Optional[str]) -> None:
        """Records the next episode of a world as a game log; None: no longer."""
        name = None if path is None else os.fsencode(path)
        if name is not None and b"\0" in name:
            raise ValueError(f"record: {path!r} holds a null character")
        _check(self.call("record", env, name))

    def view(self, env: int) -> World:
        """The physical state of a world."""
        world = World(struct_size=ctypes.sizeof(World))
        _check(self.call("view", env, ctypes.byref(world)))
        return world

    def set_state(self, env: int, world: World) -> None:
        """Starts an episode from a physical state."""
        try:
            _check(self.call("set_state", env, ctypes.byref(world)))
        except ConfigError as error:
            raise ConfigError(f"set_state: {error}") from None

    def close(self) -> None:
        """Frees the worlds; may be called again. Raises EngineError when a recording could not be
        written."""
        self.closed = True
        _check(self._free() or 0)


def _spec(document: Dict[str, Any]) -> Spec:
    def features(items: List[Dict[str, Any]]) -> Tuple[Feature, ...]:
        return tuple(Feature(one["name"], one["unit"], one["low"], one["high"]) for one in items)

    actions = document["actions"]
    return Spec(
        task=document["task"], agents=tuple(document["agents"]),
        feature_set=document["features"]["set"], feature_version=document["features"]["version"],
        features=features(document["features"]["items"]),
        state_features=features(document["state"]["items"]),
        actions=ActionSet(
            actions["set"], actions["version"],
            tuple(one["name"] for one in actions["items"]) if actions["ids"] else (),
            tuple(features(one["parameters"]) for one in actions["items"]),
            features(actions["value_items"]),
            tuple(Sense(one["name"], tuple(one["items"])) for one in document["senses"])),
        reward_terms=tuple(one["name"] for one in document["reward_terms"]),
        statuses=tuple(_status_name(one) for one in document["statuses"]),
        options=tuple(document["options"]), opponents=tuple(document["opponents"]),
        document=document)


def _status_name(entry: Any) -> str:
    return str(entry["name"] if isinstance(entry, dict) else entry)


