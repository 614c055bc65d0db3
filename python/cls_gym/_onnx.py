"""Reads the part of ONNX files that small networks need, with NumPy alone: nodes, weights, names.

An ONNX file is a message of protocol buffers: fields of a number, a kind and a value.
"""
from __future__ import annotations

import dataclasses
import math
import pathlib
import struct
from typing import Any, Dict, Iterator, List, Tuple, Union

import numpy as np

from cls_gym.network import MAX_WEIGHTS

Value = Union[int, bytes]
Fields = Dict[int, List[Value]]
# By TensorProto.DataType: the type of raw bytes, and the field of numbers that are not raw.
_TYPES: Dict[int, Tuple[str, int]] = {1: ("<f4", 4), 6: ("<i4", 5), 7: ("<i8", 7), 9: ("?", 5),
                                      10: ("<f2", 5), 11: ("<f8", 10)}
_BFLOAT16 = 16
_EXTERNAL = 1
_MAX_DIMENSIONS = 8


class OnnxError(ValueError):
    """A file that is not an ONNX model, or weights that cannot be read."""


@dataclasses.dataclass
class Node:
    """An operator with the names of what it reads and writes."""

    op: str
    name: str
    inputs: List[str]
    outputs: List[str]
    attributes: Dict[str, Any]


@dataclasses.dataclass
class Graph:
    """nodes in the order of evaluation; weights by name; names of the inputs without weights, each
    with its last dimension (0: not fixed), and of the outputs."""

    nodes: List[Node]
    weights: Dict[str, Tensor]
    inputs: Dict[str, int]
    outputs: List[str]


@dataclasses.dataclass
class Tensor:
    """Weights that are decoded when they are needed. folder: of data beside the file."""

    fields: Fields
    folder: pathlib.Path

    def array(self) -> np.ndarray:
        """Raises OnnxError for types that are not numbers, and for data that does not fit."""
        kind = _integer(self.fields, 2)
        if kind not in _TYPES:
            name = "bfloat16" if kind == _BFLOAT16 else f"data type {kind}"
            raise OnnxError(f"weights of {name} are not read")
        dtype, field = _TYPES[kind]
        shape = self._shape()
        if _integer(self.fields, 14) == _EXTERNAL:
            flat = np.frombuffer(self._beside(math.prod(shape) * np.dtype(dtype).itemsize), dtype)
        elif 9 in self.fields:
            flat = np.frombuffer(_bytes(self.fields[9][-1]), dtype)
        elif field in (5, 7):
            flat = _of_integers(_integers(self.fields.get(field, [])), kind, dtype)
        else:
            flat = np.frombuffer(b"".join(_bytes(one) for one in self.fields.get(field, [])), dtype)
        if flat.size != math.prod(shape):
            raise OnnxError(f"weights {tuple(shape)} of {flat.size} numbers")
        return flat.reshape(shape)

    def _shape(self) -> List[int]:
        shape = [_signed(one) for one in _integers(self.fields.get(1, []))]
        if len(shape) > _MAX_DIMENSIONS:
            raise OnnxError(f"weights of {len(shape)} dimensions")
        if min(shape, default=0) < 0:
            raise OnnxError(f"weights {tuple(shape)} of a negative size")
        if math.prod(shape) > MAX_WEIGHTS:
            raise OnnxError(f"weights {tuple(shape)}, and a match takes at most {MAX_WEIGHTS}")
        return shape

    def _beside(self, size: int) -> bytes:
        """Bytes of a file in the model's folder, which no link may leave."""
        about = {_text(entry, 1): _text(entry, 2) for entry in _messages(self.fields, 13)}
        location = about.get("location", "")
        try:
            place = pathlib.PurePosixPath(location)
            folder = self.folder.resolve()
            if place.is_absolute() or ".." in place.parts or \
                    folder not in (folder / place).resolve().parents:
                raise OnnxError("is outside of the model's folder")
            file = (folder / place).resolve(strict=True)
            if not file.is_file():  # to open a pipe may take forever
                raise OnnxError("is not a file")
            return _part(file, int(about.get("offset", "0")), int(about.get("length", size)), size)
        except OSError as error:
            raise OnnxError(f"weights in {location!r}: {error.strerror or error}") from error
        except (RuntimeError, ValueError) as error:  # a loop of links; numbers that are not numbers
            raise OnnxError(f"weights in {location!r}: {error}") from error


def _part(file: pathlib.Path, offset: int, length: int, size: int) -> bytes:
    if length != size or not 0 <= offset <= file.stat().st_size - size:
        raise OnnxError(f"has no {length} bytes from byte {offset} on for weights of {size} bytes")
    with open(file, "rb") as opened:
        opened.seek(offset)
        return opened.read(size)


def _of_integers(numbers: List[int], kind: int, dtype: str) -> np.ndarray:
    """Numbers of weights that are not raw; those of two bytes are written as their bits."""
    wide = np.array([_signed(one) for one in numbers], np.int64)
    if dtype == "?":
        return wide.astype(bool)
    narrow = "<u2" if dtype == "<f2" else dtype
    limits = np.iinfo(narrow)
    if not ((wide >= limits.min) & (wide <= limits.max)).all():
        raise OnnxError(f"weights of data type {kind} are out of its range")
    return wide.astype(narrow).view(dtype)


def read(path: Union[str, pathlib.Path]) -> Graph:
    """The graph of a file. Raises OnnxError; OSError if the file cannot be read; MemoryError."""
    where = pathlib.Path(path)
    content = where.read_bytes()
    try:
        graph = b"".join(_bytes(one) for one in _fields(content).get(7, []))
        if not graph:
            raise ValueError("it has no graph")
        return _graph(_fields(graph), where.parent)
    except MemoryError:
        raise
    except Exception as error:  # an untrusted file may be damaged in any way
        raise OnnxError(f"is not an ONNX model: {error}") from error


def _graph(fields: Fields, folder: pathlib.Path) -> Graph:
    weights = {_text(one, 8): Tensor(one, folder) for one in _messages(fields, 5)}
    nodes = [_node(one, folder) for one in _messages(fields, 1)]
    inputs = {_text(one, 1): _last_dimension(one) for one in _messages(fields, 11)}
    inputs = {name: size for name, size in inputs.items() if name not in weights}
    given = set(weights) | set(inputs)
    for name in (name for node in nodes for name in node.outputs if name):
        if name in given:
            raise ValueError(f"it computes {name!r} twice")
        given.add(name)
    return Graph(nodes, weights, inputs, [_text(one, 1) for one in _messages(fields, 12)])


def _node(fields: Fields, folder: pathlib.Path) -> Node:
    domain = _text(fields, 7)
    op = _text(fields, 4) if domain in ("", "ai.onnx") else f"{domain}.{_text(fields, 4)}"
    return Node(op, _text(fields, 3), [_bytes(one).decode() for one in fields.get(1, [])],
                [_bytes(one).decode() for one in fields.get(2, [])],
                {_text(one, 1): _attribute(one, folder) for one in _messages(fields, 5)})


def _attribute(fields: Fields, folder: pathlib.Path) -> Any:
    """A float, an integer, a tensor or a list of integers; None for others."""
    kind = _integer(fields, 20)
    if kind == 1:
        return struct.unpack("<f", _bytes(fields.get(2, [bytes(4)])[-1]))[0]
    if kind == 2:
        return _signed(_integer(fields, 3))
    if kind == 4:
        return Tensor((_messages(fields, 5) or [{}])[-1], folder)
    return [_signed(one) for one in _integers(fields.get(8, []))] if kind == 7 else None


def _last_dimension(value: Fields) -> int:
    for kind in _messages(value, 2):
        for tensor in _messages(kind, 1):
            for shape in _messages(tensor, 2):
                sizes = [_signed(_integer(one, 1)) for one in _messages(shape, 1)]
                return max(sizes[-1], 0) if sizes else 0
    return 0


def _fields(data: bytes) -> Fields:
    found: Fields = {}
    for number, value in _walk(data):
        found.setdefault(number, []).append(value)
    return found


def _walk(data: bytes) -> Iterator[Tuple[int, Value]]:
    at = 0
    while at < len(data):
        key, at = _varint(data, at)
        if key & 7 == 0:
            value, at = _varint(data, at)
            yield key >> 3, value
            continue
        size = {1: 8, 5: 4}.get(key & 7)
        if key & 7 == 2:
            size, at = _varint(data, at)
        if size is None or at + size > len(data):
            raise ValueError("it is cut off or no message of protocol buffers")
        yield key >> 3, data[at:at + size]
        at += size


def _varint(data: bytes, at: int) -> Tuple[int, int]:
    value = 0
    for shift in range(0, 70, 7):
        if at >= len(data):
            raise ValueError("it is cut off")
        byte = data[at]
        value |= (byte & 0x7F) << shift
        at += 1
        if byte < 0x80:
            return value & (1 << 64) - 1, at
    raise ValueError("a number has no end")


def _messages(fields: Fields, number: int) -> List[Fields]:
    return [_fields(_bytes(one)) for one in fields.get(number, [])]


def _text(fields: Fields, number: int) -> str:
    return _bytes(fields[number][-1]).decode() if number in fields else ""


def _integer(fields: Fields, number: int) -> int:
    return _integers(fields.get(number, [0]))[-1]


def _integers(values: List[Value]) -> List[int]:
    """Of a repeated field, packed or not."""
    numbers: List[int] = []
    for value in values:
        if isinstance(value, int):
            numbers.append(value)
            continue
        at = 0
        while at < len(value):
            number, at = _varint(value, at)
            numbers.append(number)
    return numbers


def _signed(value: int) -> int:
    return value - (1 << 64) if value >= 1 << 63 else value


def _bytes(value: Value) -> bytes:
    if isinstance(value, int):
        raise ValueError("a number where a text or message was expected")
    return value
