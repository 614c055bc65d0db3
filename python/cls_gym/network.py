"""Networks of policy files cls.policy/2, in NumPy: what `cls match policy:FILE` computes, bit for bit.

A file is the eight bytes "CLSPOL2" and a line feed, the length of a JSON text as a little-endian
32-bit number, the text, and the weights as little-endian float32 (docs/formats/policy.md). The text
has the members of cls_gym.policy.describe(), `decides` and `steps`: operations by name, of which the
last one gives a score per action id.
"""
from __future__ import annotations

import dataclasses
import json
import math
import pathlib
import struct
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from cls_gym._files import replaced

SCHEMA = "cls.policy/2"
MAGIC = b"CLSPOL2\n"
KINDS = ("columns", "norm", "dense", "pool", "concat", "flatten", "gru")
ACTIVATIONS = ("none", "relu", "tanh")
# Of the networks that a match plays, as training/policy/network.h has them.
MAX_STEPS = 100
MAX_NUMBERS = 1 << 16  # of a result
MAX_WEIGHTS = 1 << 24
Memory = Dict[str, np.ndarray]


class PolicyError(ValueError):
    """A file that is not a policy, or one for other features or actions."""


@dataclasses.dataclass
class Step:
    """An operation on rows of numbers; `of` names the results that it reads, or "features".

    columns: `rows` rows of `width` numbers from index `first` on. norm: x * scale + shift; weights:
    scale[in], shift[in]. dense: of each row `width` numbers and an `activation`; weights:
    weight[in, width], bias[width]. pool: mean and maximum over the rows whose first column in the
    second input is above 0. concat: columns side by side, one row joins each row of the others.
    flatten: all rows as one. gru: weights: weight[in, 3 width], bias[3 width], weight[width, 3 width],
    bias[3 width], in the order reset, update, new.
    """

    name: str
    kind: str
    of: Sequence[str]
    first: int = 0
    rows: int = 0
    width: int = 0
    activation: str = "none"
    weights: Sequence[np.ndarray] = ()

    def document(self) -> Dict[str, Any]:
        """The step as the text of a file has it."""
        one: Dict[str, Any] = {"name": self.name, "kind": self.kind, "of": list(self.of)}
        if self.kind == "columns":
            one.update(first=self.first, rows=self.rows)
        if self.kind in ("columns", "dense", "gru"):
            one["width"] = self.width
        if self.kind == "dense":
            one["activation"] = self.activation
        return one


def tanh(x: np.ndarray) -> np.ndarray:
    """By a rational function, float32: exact operations only, which give the same bits everywhere.

    >>> bool(np.abs(tanh(np.float32([-9, -0.3, 0, 2])) - np.tanh([-9, -0.3, 0, 2])).max() < 4e-7)
    True
    """
    y = np.clip(np.asarray(x, np.float32), np.float32(-7.9), np.float32(7.9))
    z = y * y
    p = np.full_like(z, -2.76076847742355e-16)
    for c in (2.00018790482477e-13, -8.60467152213735e-11, 5.12229709037114e-08,
              1.48572235717979e-05, 6.37261928875436e-04, 4.89352455891786e-03):
        p = p * z + np.float32(c)
    q = np.full_like(z, 1.19825839466702e-06)
    for c in (1.18534705686654e-04, 2.26843463243900e-03, 4.89352518554385e-03):
        q = q * z + np.float32(c)
    return np.asarray(y * p / q, np.float32)


def _sigmoid(x: np.ndarray) -> np.ndarray:
    return np.float32(0.5) * tanh(np.float32(0.5) * x) + np.float32(0.5)


def _in_order(x: np.ndarray, weight: np.ndarray, bias: np.ndarray) -> np.ndarray:
    """x @ weight + bias with the sums of the engine: the bias, then the inputs in their order."""
    total = np.broadcast_to(bias, x.shape[:-1] + bias.shape).copy()
    for i in range(len(weight)):
        total += x[..., i:i + 1] * weight[i]
    return total


def _at_once(x: np.ndarray, weight: np.ndarray, bias: np.ndarray) -> np.ndarray:
    return np.asarray(x @ weight + bias, np.float32)


Product = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


class Network:
    """A policy of steps. about: what cls_gym.policy.describe() says, and `decides` ("ball" or
    "all"): the decisions that the policy makes in a match."""

    def __init__(self, steps: Sequence[Step], about: Dict[str, Any]) -> None:
        self.steps = [dataclasses.replace(step, weights=[np.asarray(one, np.float32)
                                                         for one in step.weights])
                      for step in steps]
        self.about = dict(about, schema=SCHEMA)

    def scores(self, observations: np.ndarray, memory: Optional[Memory] = None) -> np.ndarray:
        """float32[..., K] of observations float32[..., F]. memory: states of gru steps by name, kept
        from call to call; an empty dictionary at first."""
        return self._run(observations, memory, _at_once)

    def exact_scores(self, observations: np.ndarray,
                     memory: Optional[Memory] = None) -> np.ndarray:
        """scores() with the bits of the engine; slow."""
        return self._run(observations, memory, _in_order)

    def act(self, observations: np.ndarray, masks: Optional[np.ndarray] = None) -> np.ndarray:
        """int64[...]: the id with the highest score among those whose mask is not 0."""
        scores = self.scores(observations)
        if masks is not None:
            scores = np.where(masks != 0, scores, -np.inf)
        return np.asarray(scores.argmax(axis=-1))

    def save(self, path: Union[str, pathlib.Path]) -> None:
        """Writes the file; it is complete or as it was before."""
        text = json.dumps(dict(self.about, steps=[step.document() for step in self.steps]))
        encoded = text.encode()
        numbers = [np.ascontiguousarray(one, "<f4").tobytes()
                   for step in self.steps for one in step.weights]
        content = MAGIC + struct.pack("<I", len(encoded)) + encoded + b"".join(numbers)
        with replaced(path) as partial:
            partial.write_bytes(content)

    def _run(self, observations: np.ndarray, memory: Optional[Memory],
             product: Product) -> np.ndarray:
        features = np.asarray(observations, np.float32)
        results = {"features": features.reshape(-1, 1, features.shape[-1])}
        for step in self.steps:
            inputs = [results[name] for name in step.of]
            results[step.name] = _apply(step, inputs, {} if memory is None else memory, product)
        last = results[self.steps[-1].name]
        return last.reshape(features.shape[:-1] + (last.shape[1] * last.shape[2],))


def _apply(step: Step, inputs: List[np.ndarray], memory: Memory, product: Product) -> np.ndarray:
    """The result [B, rows, width] of inputs of such shapes."""
    x, weights = inputs[0], step.weights
    if step.kind == "columns":
        count = step.rows * step.width
        return x[:, 0, step.first:step.first + count].reshape(-1, step.rows, step.width)
    if step.kind == "norm":
        return np.asarray(x * weights[0] + weights[1], np.float32)
    if step.kind == "dense":
        total = product(x, weights[0], weights[1])
        if step.activation == "relu":
            return np.where(total > 0, total, np.float32(0))
        return tanh(total) if step.activation == "tanh" else total
    if step.kind == "pool":
        return _pool(x, inputs[1][:, :, 0] > 0)
    if step.kind == "concat":
        rows = max(one.shape[1] for one in inputs)
        return np.concatenate([np.broadcast_to(one, (len(one), rows, one.shape[2]))
                               for one in inputs], axis=2)
    if step.kind == "flatten":
        return x.reshape(len(x), 1, -1)
    return _gru(step, x, memory, product)


def _pool(x: np.ndarray, there: np.ndarray) -> np.ndarray:
    total = np.zeros((len(x), x.shape[2]), np.float32)
    most = np.zeros_like(total)
    count = np.zeros((len(x), 1), np.float32)
    for row in range(x.shape[1]):
        counts, values = there[:, row:row + 1], x[:, row]
        total = np.where(counts, total + values, total)
        most = np.where(counts & ((count == 0) | (values > most)), values, most)
        count += counts
    mean = np.where(count > 0, total / np.maximum(count, 1), total)
    return np.concatenate([mean, most], axis=1).astype(np.float32)[:, None]


def _gru(step: Step, x: np.ndarray, memory: Memory, product: Product) -> np.ndarray:
    width = step.width
    state = memory.get(step.name)
    if state is None:
        state = np.zeros((len(x), width), np.float32)
    of_input = product(x[:, 0], step.weights[0], step.weights[1])
    of_state = product(state, step.weights[2], step.weights[3])
    reset = _sigmoid(of_input[:, :width] + of_state[:, :width])
    update = _sigmoid(of_input[:, width:2 * width] + of_state[:, width:2 * width])
    new = tanh(of_input[:, 2 * width:] + reset * of_state[:, 2 * width:])
    memory[step.name] = (np.float32(1) - update) * new + update * state
    return memory[step.name][:, None]


def shapes(steps: Sequence[Step], features: int) -> List[List[Tuple[int, ...]]]:
    """Of the weights of each step. Raises PolicyError for steps that do not fit each other, and for
    more than a match plays."""
    if not 1 <= len(steps) <= MAX_STEPS:
        raise PolicyError(f"has {len(steps)} steps, and a match plays 1 to {MAX_STEPS}")
    sizes: Dict[str, Tuple[int, int]] = {"features": (1, features)}
    wanted: List[List[Tuple[int, ...]]] = []
    for number, step in enumerate(steps, 1):
        unknown = [name for name in step.of if name not in sizes]
        if step.kind not in KINDS or step.activation not in ACTIVATIONS or unknown \
                or step.name in sizes or len(step.of) < 1 + (step.kind == "pool"):
            raise PolicyError(f"step {number}: {step.document()} is not a step after the others")
        rows, width = sizes[step.of[0]]
        of_step: Dict[str, List[Tuple[int, ...]]] = {
            "norm": [(width,), (width,)], "dense": [(width, step.width), (step.width,)],
            "gru": [(width, 3 * step.width), (3 * step.width,), (step.width, 3 * step.width),
                    (3 * step.width,)]}
        wanted.append(of_step.get(step.kind, []))
        sizes[step.name] = {
            "columns": (step.rows, step.width), "dense": (rows, step.width), "pool": (1, 2 * width),
            "concat": (max(sizes[name][0] for name in step.of),
                       sum(sizes[name][1] for name in step.of)),
            "flatten": (1, rows * width), "gru": (1, step.width)}.get(step.kind, (rows, width))
        if min(sizes[step.name]) < 1 or math.prod(sizes[step.name]) > MAX_NUMBERS:
            raise PolicyError(f"step {number}: makes {' x '.join(map(str, sizes[step.name]))} "
                              f"numbers, and a match takes 1 to {MAX_NUMBERS}")
    count = sum(math.prod(shape) for of_one in wanted for shape in of_one)
    if count > MAX_WEIGHTS:
        raise PolicyError(f"has {count} weights, and a match takes at most {MAX_WEIGHTS}")
    return wanted


def load(path: Union[str, pathlib.Path]) -> Network:
    """Reads a file. Raises PolicyError if it is not one."""
    try:
        content = pathlib.Path(path).read_bytes()
    except OSError as error:
        raise PolicyError(f"{path}: cannot read: {error.strerror or error}") from error
    try:
        if not content.startswith(MAGIC):
            raise ValueError("it does not begin as one")
        start = len(MAGIC) + 4
        length = struct.unpack("<I", content[len(MAGIC):start])[0]
        about = json.loads(content[start:start + length].decode())
        numbers = np.frombuffer(content[start + length:], "<f4")
        steps = [Step(**one) for one in about.pop("steps")]
        if about.get("schema") != SCHEMA:
            raise ValueError(f"schema is not {SCHEMA}")
        used = 0
        for step, of_step in zip(steps, shapes(steps, len(about["feature_names"]))):
            taken = []
            for shape in of_step:
                count = int(np.prod(shape))
                taken.append(numbers[used:used + count].reshape(shape))
                used += count
            step.weights = taken
        if used != len(numbers):
            raise ValueError("the number of weights is another one")
    except PolicyError as error:
        raise PolicyError(f"{path}: {error}") from error
    except Exception as error:  # an untrusted file may be damaged in any way
        raise PolicyError(f"{path}: is not a policy of {SCHEMA}: {error}") from error
    return Network(steps, about)
