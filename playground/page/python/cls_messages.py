"""Messages of the interface for teams in the page, from the description that the engine gives of them.

They have the names and the meaning of those that protoc generates; a message is decoded when it is read.
"""
from __future__ import annotations

import struct
from typing import Any, Dict, List, Tuple

_VARINT, _FIXED64, _BYTES, _FIXED32 = 0, 1, 2, 5  # kinds of the wire
_DEFAULTS: Dict[str, Any] = {"string": "", "bool": False, "float": 0.0, "double": 0.0}
_classes: Dict[str, Any] = {}


def _varint(data: Any, at: int) -> Tuple[int, int]:
    value = shift = 0
    while True:
        byte = data[at]
        at += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, at
        shift += 7


def _put_varint(out: bytearray, value: int) -> None:
    value &= (1 << 64) - 1
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)


class Message:
    """A message: its fields are attributes, unset ones have the values that protobuf gives them."""

    _fields: Dict[str, Any] = {}

    def __init__(self, **values: Any) -> None:
        self._raw: Dict[int, List[Any]] = {}
        self._given = set(values)
        for name, value in values.items():
            if name not in self._fields:
                raise ValueError(f"{type(self).__name__} has no field {name}")
            self.__dict__[name] = value

    @classmethod
    def FromString(cls, data: Any) -> Any:
        """Reads the bytes of a message, which may be a memoryview."""
        made = cls()
        at = 0
        while at < len(data):
            key, at = _varint(data, at)
            value, at = _value_at(data, at, key & 7)
            made._raw.setdefault(key >> 3, []).append(value)
        return made

    def __getattr__(self, name: str) -> Any:
        field = self._fields.get(name)
        if field is None:
            raise AttributeError(f"{type(self).__name__} has no field {name}")
        value = _read(field, self._raw.get(field["number"], []))
        self.__dict__[name] = value
        return value

    def HasField(self, name: str) -> bool:
        """Whether a message or a field of a oneof is set."""
        return name in self._given or self._fields[name]["number"] in self._raw

    def SerializeToString(self) -> bytes:
        """The bytes of what a program has set."""
        out = bytearray()
        for name, value in self.__dict__.items():
            field = self._fields.get(name)
            if field is None:
                continue  # of this class
            for each in value if field.get("repeated") else [value]:
                _write(out, field, each)
        return bytes(out)


def _value_at(data: Any, at: int, kind: int) -> Tuple[Any, int]:
    if kind == _VARINT:
        return _varint(data, at)
    if kind == _BYTES:
        size, at = _varint(data, at)
        return data[at:at + size], at + size
    if kind == _FIXED32:
        return struct.unpack_from("<f", data, at)[0], at + 4
    return struct.unpack_from("<d", data, at)[0], at + 8


def _decoded(field: Any, value: Any) -> Any:
    kind = field["type"]
    if kind == "message":
        return _classes[field["of"]].FromString(value)
    if kind == "string":
        return bytes(value).decode()
    if kind == "bool":
        return bool(value)
    if kind in ("int32", "int64", "enum"):
        return value - (1 << 64) if value >> 63 else value
    return value


def _numbers(field: Any, data: Any) -> List[Any]:
    """The elements of a packed list."""
    kind = {"float": _FIXED32, "double": _FIXED64}.get(field["type"], _VARINT)
    values = []
    at = 0
    while at < len(data):
        value, at = _value_at(data, at, kind)
        values.append(_decoded(field, value))
    return values


def _read(field: Any, found: List[Any]) -> Any:
    if field.get("map"):
        return {entry.key: entry.value for entry in (_decoded(field, each) for each in found)}
    if field.get("repeated"):
        if field["type"] in ("message", "string"):
            return [_decoded(field, each) for each in found]
        return [value for each in found for value in
                (_numbers(field, each) if isinstance(each, (bytes, memoryview)) else [_decoded(field, each)])]
    if found:
        return _decoded(field, found[-1])
    if field["type"] == "message":
        return _classes[field["of"]]()
    return _DEFAULTS.get(field["type"], 0)


def _write(out: bytearray, field: Any, value: Any) -> None:
    kind, number = field["type"], field["number"]
    if kind == "float" or kind == "double":
        _put_varint(out, number << 3 | (_FIXED32 if kind == "float" else _FIXED64))
        out += struct.pack("<f" if kind == "float" else "<d", value)
    elif kind == "message" or kind == "string":
        data = value.SerializeToString() if kind == "message" else value.encode()
        _put_varint(out, number << 3 | _BYTES)
        _put_varint(out, len(data))
        out += data
    else:
        _put_varint(out, number << 3)
        _put_varint(out, int(value))


def add_messages(schema: Any, module: Any) -> None:
    """Adds the classes and the values of enumerations to a module."""
    for name, fields in schema["messages"].items():
        short = name.rsplit(".", 1)[-1]
        _classes[name] = type(short, (Message,), {"_fields": {field["name"]: field for field in fields}})
        setattr(module, short, _classes[name])
    for values in schema["enums"].values():
        for name, number in values.items():
            setattr(module, name, number)
