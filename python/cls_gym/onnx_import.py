"""Policies of ONNX files: networks of any framework that exports them become files cls.policy/2.

    python3 -m cls_gym.onnx_import model.onnx mine.policy

reads multilayer perceptrons, as torch.onnx.export writes those of Stable-Baselines3 and TorchRL:
Gemm, and MatMul with Add; Relu and Tanh after them; Add, Sub, Mul, Div and BatchNormalization with
fixed numbers; Concat; what changes no number (Identity, Dropout, Cast, Flatten, Reshape). A Softmax
at the end changes no choice and is left out. It needs NumPy alone.
"""
from __future__ import annotations

import argparse
import dataclasses
import pathlib
import sys
from typing import Any, Callable, Dict, List, Optional, Sequence, Set, Union

import numpy as np

import cls_gym
from cls_gym._onnx import Graph, Node, OnnxError, Tensor, read
from cls_gym.network import MAX_NUMBERS, MAX_WEIGHTS, Network, PolicyError, Step, shapes
from cls_gym.policy import describe

DECIDES = ("ball", "all")
Result = Union[str, np.ndarray]  # the name of a step, or fixed numbers
_MOST_BUILT = 8 * MAX_WEIGHTS  # numbers of layers, those included that others replace
_LONGEST = 1000  # characters of a message, in which names of the file may stand


def from_onnx(path: Union[str, pathlib.Path], about: Dict[str, Any],
              output: Optional[str] = None) -> Network:
    """The network of an ONNX file. about: what cls_gym.policy.describe() says, and `decides`; the
    network reads its features and scores its actions. output: the name of the output with the
    scores; by default the only one with a number per action. Raises PolicyError."""
    try:
        graph = read(path)
        names = graph.outputs if output is None else [output]
        found: Dict[str, List[Step]] = {}
        problems = []
        for name in names:
            try:
                with np.errstate(all="ignore"):  # what is not finite is refused
                    found[name] = _steps_to(graph, name, about)
            except PolicyError as error:
                problems.append(str(error))
        if not found:
            raise PolicyError(problems[0] if problems else "the model has no output")
        if len(found) > 1:
            raise PolicyError(f"each of the outputs {', '.join(found)} has a number per action: "
                              "name one")
        return Network(next(iter(found.values())), about)
    except MemoryError as error:
        raise PolicyError(_printable(f"{path}: takes more memory than there is")) from error
    except (OnnxError, OSError, PolicyError) as error:
        why = error.strerror if isinstance(error, OSError) and error.strerror else error
        raise PolicyError(_printable(f"{path}: {str(why)[:_LONGEST]}")) from error


def _printable(text: str) -> str:
    """One line without control characters, which names of an untrusted file may have."""
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode()
                   for one in text)


def _steps_to(graph: Graph, output: str, about: Dict[str, Any]) -> List[Step]:
    """The steps before an output, the last of which scores the actions."""
    converter = _Converter(graph, len(about["feature_names"]))
    result = converter.output(output)
    width, count = converter.width(result), len(about["action_names"])
    if width != count:
        raise PolicyError(f"output {output!r} has {width} numbers, and there are {count} actions")
    steps = converter.steps_to(result)
    shapes(steps, len(about["feature_names"]))
    if not all(np.isfinite(np.asarray(one, np.float32)).all()
               for step in steps for one in step.weights):
        raise PolicyError(f"output {output!r} has weights that are not finite numbers")
    return steps


class _Converter:
    """Turns nodes into steps. No step changes after it was added: an Add or a Tanh after a layer
    makes another layer, and only the last of them is needed in the end."""

    def __init__(self, graph: Graph, features: int) -> None:
        self._graph = graph
        self._makers = {node.outputs[0]: node for node in graph.nodes if any(node.outputs[:1])}
        self._built = 0
        self._results: Dict[str, Result] = {}
        self._steps: Dict[str, Step] = {}
        self._widths = {"features": features}

    def output(self, name: str) -> str:
        """The step that computes an output, or what is before its Softmax."""
        node, seen = self._maker(name), {name}
        while node.op in ("Softmax", "LogSoftmax"):
            _demand(node, node.attributes.get("axis", -1) in (-1, 1), "is not along the actions")
            _demand(node, bool(node.inputs), "has no input")
            name = node.inputs[0]
            _demand(node, name not in seen, "reads what follows from it")
            seen.add(name)
            node = self._maker(name)
        nodes = self._needed(name)
        self._demand_one_input(nodes)
        for one in nodes:
            self._convert(one)
        result = self._results[name]
        if isinstance(result, np.ndarray) or result == "features":
            raise PolicyError(f"output {name!r} is not computed from the features")
        return result

    def _maker(self, output: str) -> Node:
        if output in self._makers:
            return self._makers[output]
        for node in self._graph.nodes:
            _demand(node, output not in node.outputs, f"its output {output!r} is not read")
        raise PolicyError(f"no node computes an output {output!r}; outputs: "
                          f"{', '.join(self._graph.outputs)}")

    def _demand_one_input(self, nodes: List[Node]) -> None:
        read = {name for node in nodes for name in node.inputs}
        names = [repr(name) for name in self._graph.inputs if name in read]
        if len(names) > 1:
            count = "two" if len(names) == 2 else len(names)
            raise PolicyError(f"reads {count} inputs, {', '.join(names[:-1])} and {names[-1]}")

    def steps_to(self, result: str) -> List[Step]:
        """Those that `result` needs, renamed by kind and number."""
        needed = {result}
        for name in reversed(list(self._steps)):
            if name in needed:
                needed.update(self._steps[name].of)
        names = {"features": "features"}
        counts = {"dense": 0, "norm": 0, "concat": 0}
        steps: List[Step] = []
        for name, step in self._steps.items():
            if name in needed:
                counts[step.kind] += 1
                names[name] = f"{step.kind}{counts[step.kind]}"
                steps.append(dataclasses.replace(step, name=names[name],
                                                 of=[names[one] for one in step.of]))
        return steps

    def _needed(self, output: str) -> List[Node]:
        """The nodes that an output depends on, in the order of the file."""
        found: Set[int] = set()
        waiting = [output]
        while waiting:
            node = self._makers.get(waiting.pop())
            if node is not None and id(node) not in found:
                found.add(id(node))
                waiting += node.inputs
        return [node for node in self._graph.nodes if id(node) in found]

    def _convert(self, node: Node) -> None:
        handler = _HANDLERS.get(node.op)
        if handler is None:
            raise PolicyError(f"{_title(node)}: is not one of {', '.join(sorted(_HANDLERS))}")
        try:
            self._results[node.outputs[0]] = handler(self, node)
        except (MemoryError, PolicyError):
            raise
        except OnnxError as error:
            raise PolicyError(f"{_title(node)}: {error}") from error
        except Exception as error:  # an untrusted file may be damaged in any way
            why = str(error) or type(error).__name__
            raise PolicyError(f"{_title(node)}: is damaged: {why}") from error

    # For the handlers.

    def result(self, node: Node, index: int = 0) -> Result:
        """What an input of a node stands for."""
        _demand(node, index < len(node.inputs), f"has no input {index + 1}")
        name = node.inputs[index]
        if name not in self._results:
            self._results[name] = self._first_result(name)
        return self._results[name]

    def _first_result(self, name: str) -> Result:
        if name in self._graph.weights:
            return self._graph.weights[name].array()
        if name not in self._graph.inputs:
            raise PolicyError(f"nothing computes {name!r} before it is read")
        size, features = self._graph.inputs[name], self._widths["features"]
        if size not in (0, features):
            raise PolicyError(f"input {name!r} has {size} numbers, and there are {features} "
                              "features")
        return "features"

    def fixed(self, node: Node, index: int) -> np.ndarray:
        """An input that is a number of the file."""
        numbers = self.result(node, index)
        if isinstance(numbers, str):
            raise PolicyError(f"{_title(node)}: input {index + 1} is not fixed")
        return numbers

    def moving(self, node: Node, index: int = 0) -> str:
        """The step of an input that follows from the features."""
        step = self.result(node, index)
        if isinstance(step, np.ndarray):
            raise PolicyError(f"{_title(node)}: input {index + 1} is fixed")
        return step

    def width(self, step: str) -> int:
        return self._widths[step]

    def last(self, name: str) -> Optional[Step]:
        """A step; None for the features."""
        return self._steps.get(name)

    def add(self, node: Node, kind: str, of: List[str], width: int,
            weights: Sequence[np.ndarray] = (), activation: str = "none") -> str:
        """A new step, by its name. Raises PolicyError for more than a match takes."""
        _demand(node, 1 <= width <= MAX_NUMBERS,
                f"makes {width} numbers, and a match takes 1 to {MAX_NUMBERS}")
        self._built += sum(one.size for one in weights)
        _demand(node, self._built <= _MOST_BUILT,
                f"layers up to here have more than {_MOST_BUILT} weights")
        name = f"{kind} {len(self._steps)}"
        self._steps[name] = Step(name, kind, of, width=width if kind == "dense" else 0,
                                 activation=activation, weights=weights)
        self._widths[name] = width
        return name

    def add_layer(self, node: Node, of: str, weight: np.ndarray, bias: np.ndarray) -> str:
        _demand(node, weight.ndim == 2 and len(weight) == self.width(of),
                f"weights {weight.shape} do not fit {self.width(of)} numbers")
        width = weight.shape[1]
        return self.add(node, "dense", [of], width, [weight, _row(node, bias, width)])


def _title(node: Node) -> str:
    return f"{node.op} {node.name!r}" if node.name else node.op


def _demand(node: Node, true: bool, otherwise: str) -> None:
    if not true:
        raise PolicyError(f"{_title(node)}: {otherwise}")


def _row(node: Node, numbers: np.ndarray, width: int) -> np.ndarray:
    """[width]: the same numbers for each row, or one number for all."""
    _demand(node, numbers.size in (1, width) and numbers.shape[-1:] in ((), (1,), (width,))
            and numbers.size == int(np.prod(numbers.shape[-1:])),
            f"numbers {numbers.shape} do not fit {width} numbers")
    return np.broadcast_to(numbers.reshape(-1), (width,))


def _gemm(c: _Converter, node: Node) -> Result:
    of, weight = c.moving(node), c.fixed(node, 1)
    get = node.attributes.get
    _demand(node, not get("transA", 0), "transA is not read")
    if get("transB", 0):
        weight = weight.T
    bias = c.fixed(node, 2) if len(node.inputs) > 2 and node.inputs[2] else np.zeros(1)
    return c.add_layer(node, of, weight * get("alpha", 1.0), bias * get("beta", 1.0))


def _matmul(c: _Converter, node: Node) -> Result:
    return c.add_layer(node, c.moving(node), c.fixed(node, 1), np.zeros(1))


def _arithmetic(c: _Converter, node: Node) -> Result:
    """x + n, x - n, n - x, x * n, x / n: of a layer without an activation in that layer."""
    flipped = isinstance(c.result(node), np.ndarray)
    of, numbers = c.moving(node, int(flipped)), c.fixed(node, int(not flipped))
    _demand(node, not (flipped and node.op == "Div"), "divides by what follows from the features")
    row = _row(node, numbers, c.width(of)).astype(np.float64)
    one, zero = np.ones_like(row), np.zeros_like(row)
    scale, shift = {"Add": (one, row), "Mul": (row, zero), "Div": (one / row, zero),
                    "Sub": (-one, row) if flipped else (one, -row)}[node.op]
    return _scaled(c, node, of, scale, shift)


def _batch_normalization(c: _Converter, node: Node) -> Result:
    of = c.moving(node)
    _demand(node, not node.attributes.get("training_mode", 0), "is that of training")
    factor, shift, mean, variance = (
        _row(node, c.fixed(node, i), c.width(of)).astype(np.float64) for i in range(1, 5))
    scale = factor / np.sqrt(variance + node.attributes.get("epsilon", 1e-5))
    return _scaled(c, node, of, scale, shift - mean * scale)


def _scaled(c: _Converter, node: Node, of: str, scale: np.ndarray, shift: np.ndarray) -> str:
    layer = c.last(of)
    if layer is None or layer.kind != "dense" or layer.activation != "none":
        return c.add(node, "norm", [of], c.width(of), [scale, shift])
    weight, bias = layer.weights
    return c.add(node, "dense", list(layer.of), layer.width,
                 [weight * scale, bias * scale + shift])


def _activation(c: _Converter, node: Node) -> Result:
    layer = c.last(c.moving(node))
    if layer is None or layer.kind != "dense" or layer.activation != "none":
        raise PolicyError(f"{_title(node)}: does not follow a Gemm or MatMul")
    return c.add(node, "dense", list(layer.of), layer.width, layer.weights, node.op.lower())


def _concat(c: _Converter, node: Node) -> Result:
    _demand(node, node.attributes.get("axis") in (-1, 1), "is not along the numbers of a row")
    of = [c.moving(node, i) for i in range(len(node.inputs))]
    return c.add(node, "concat", of, sum(map(c.width, of)))


def _same(c: _Converter, node: Node) -> Result:
    return c.result(node)


def _cast(c: _Converter, node: Node) -> Result:
    _demand(node, node.attributes.get("to") in (1, 11), "is not to float or double")
    return c.result(node)


def _dropout(c: _Converter, node: Node) -> Result:
    training = len(node.inputs) > 2 and node.inputs[2] and c.fixed(node, 2).any()
    _demand(node, not training, "is that of training")
    return c.result(node)


def _flatten(c: _Converter, node: Node) -> Result:
    _demand(node, node.attributes.get("axis", 1) in (1, -1), "joins rows")
    return c.moving(node)


def _reshape(c: _Converter, node: Node) -> Result:
    if isinstance(c.result(node), np.ndarray):
        return c.fixed(node, 0).reshape(c.fixed(node, 1))
    shape, width = c.fixed(node, 1).tolist(), c.width(c.moving(node))
    _demand(node, len(shape) == 2 and shape[0] in (-1, 0, 1) and shape[1] in (-1, 0, width),
            f"to {shape} changes rows of {width} numbers")
    return c.moving(node)


def _transpose(c: _Converter, node: Node) -> Result:
    return np.transpose(c.fixed(node, 0), node.attributes.get("perm"))


def _constant(_: _Converter, node: Node) -> Result:
    value = next(iter(node.attributes.values()), None)
    _demand(node, value is not None, "has a value that is not read")
    return value.array() if isinstance(value, Tensor) else np.array(value)


_HANDLERS: Dict[str, Callable[[_Converter, Node], Result]] = {
    "Add": _arithmetic, "BatchNormalization": _batch_normalization, "Cast": _cast,
    "Concat": _concat, "Constant": _constant, "Div": _arithmetic, "Dropout": _dropout,
    "Flatten": _flatten, "Gemm": _gemm, "Identity": _same, "MatMul": _matmul,
    "Mul": _arithmetic, "Relu": _activation, "Reshape": _reshape, "Sub": _arithmetic,
    "Tanh": _activation, "Transpose": _transpose}


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python3 -m cls_gym.onnx_import",
        description="Makes a policy for `cls match policy:OUT` of an ONNX file.")
    parser.add_argument("model", metavar="MODEL", help="ONNX file of a multilayer perceptron")
    parser.add_argument("out", metavar="OUT", help="policy file to write")
    parser.add_argument("--features", default="team", metavar="NAME",
                        help="feature set that the network observes (default: team)")
    parser.add_argument("--output", metavar="NAME",
                        help="output with the scores (default: the only one of that size)")
    parser.add_argument("--decides", choices=DECIDES, default="ball",
                        help="decisions of the policy: with the ball, or all (default: ball)")
    return parser.parse_args(arguments)


def main(arguments: Sequence[str]) -> int:
    options = _options(arguments)
    with cls_gym.VectorEnv("cls/Match-v0", 1, obs="world_model", features=options.features,
                           actions="options") as envs:
        about = dict(describe(envs), decides=options.decides)
    network = from_onnx(options.model, about, options.output)
    network.save(options.out)
    kinds = [f"{step.kind} {step.width}" if step.width else step.kind for step in network.steps]
    print(f"{options.out}: {', '.join(kinds)}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (PolicyError, cls_gym.EngineError, ImportError, OSError, ValueError) as error:
        sys.exit(f"cls_gym.onnx_import: {error}")
