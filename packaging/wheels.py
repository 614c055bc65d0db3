"""Wheels of the Python packages, written without a tool of Python's packaging: `cls_gym` with its
engine, and `cls_playmaker` with the modules of the wire. The same files give the same bytes."""
import ast
import base64
import hashlib
import pathlib
import re
import time
import typing
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PYTHON = ">=3.9"


class Distribution(typing.NamedTuple):
    """What a wheel is called, what pip installs with it, and its page."""

    package: str
    summary: str
    requires: list[str]
    extras: dict[str, list[str]]
    page: str


def constant(file: str, name: str) -> typing.Any:
    """The value of a constant that a file of python/ defines."""
    text = (SOURCE / "python" / file).read_text("utf-8")
    [value] = re.findall(rf"^{name}\b[^=\n]*= (.+)$", text, re.M)
    return ast.literal_eval(value)


def distributions() -> list[Distribution]:
    """The two distributions, with the oldest packages that they run with."""
    oldest = constant("setup.py", "OLDEST")
    gymnasium = f"gymnasium>={constant('cls_gym/_api.py', 'GYMNASIUM')}"
    gym = [gymnasium, "pettingzoo>=1.25"]
    return [
        Distribution(
            "cls_gym", "RoboCup 2D soccer environments for reinforcement learning",
            ["numpy>=1.22"],
            {"gym": gym, "sb3": [*gym, "stable-baselines3>=2.4", "sb3-contrib>=2.4"],
             "torch": [*gym, "torch", "torchrl"], "rllib": [*gym, "ray[rllib]", "torch"],
             "data": ["pyarrow>=14"], "play": ["cls-playmaker"]},
            "docs/training.md"),
        Distribution(
            "cls_playmaker", "Playmakers for RoboCup 2D soccer in Python",
            [f"{name}>={version}" for name, version in oldest.items()], {}, "python/README.md")]


def metadata(one: Distribution, version: str) -> str:
    lines = ["Metadata-Version: 2.1", f"Name: {one.package}", f"Version: {version}",
             f"Summary: {one.summary}", "License: MIT", f"Requires-Python: {PYTHON}",
             *(f"Requires-Dist: {need}" for need in one.requires)]
    for extra, needs in one.extras.items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f"Requires-Dist: {need}; extra == '{extra}'" for need in needs]
    lines.append("Description-Content-Type: text/markdown")
    return "\n".join(lines) + "\n\n" + (SOURCE / one.page).read_text("utf-8")


def write(one: Distribution, version: str, files: dict[str, bytes], platform: str, epoch: int,
          folder: pathlib.Path) -> pathlib.Path:
    """Writes a wheel of `files`, by their paths, for a platform ("any": for all)."""
    tag = f"py3-none-{platform}"
    info = f"{one.package}-{version}.dist-info"
    pure = "true" if platform == "any" else "false"
    files = {**files, f"{info}/METADATA": metadata(one, version).encode(),
             f"{info}/LICENSE": (SOURCE / "LICENSE").read_bytes(),
             f"{info}/WHEEL": (f"Wheel-Version: 1.0\nGenerator: cls {version}\n"
                               f"Root-Is-Purelib: {pure}\nTag: {tag}\n").encode()}
    record = "".join(f"{path},sha256={_digest(data)},{len(data)}\n"
                     for path, data in sorted(files.items()))
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()

    path = folder / f"{one.package}-{version}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, data in sorted(files.items()):
            entry = zipfile.ZipInfo(name, time.gmtime(epoch)[:6])
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if name.endswith(".so") else 0o100644) << 16
            archive.writestr(entry, data)
    return path


def _digest(data: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def package_files(build: pathlib.Path, package: str) -> dict[str, bytes]:
    """The files of a package in BUILD/python by their paths in a wheel."""
    root = build / "python"
    paths = [path for path in sorted((root / package).rglob("*"))
             if path.is_file() and path.suffix in (".py", ".pyi", ".typed")]
    return {str(path.relative_to(root)): path.read_bytes() for path in paths}


def write_all(build: pathlib.Path, version: str, engine: pathlib.Path, platform: str, epoch: int,
              folder: pathlib.Path) -> list[pathlib.Path]:
    """Writes both wheels; the one of cls_gym has `engine`, which is for `platform`."""
    written = []
    for one in distributions():
        files = package_files(build, one.package)
        if one.package == "cls_gym":
            files["cls_gym/libcls_training.so"] = engine.read_bytes()
        own = platform if one.package == "cls_gym" else "any"
        written.append(write(one, version, files, own, epoch, folder))
    return written
