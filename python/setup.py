"""Generates the modules of the wire for cls_playmaker; pyproject.toml has the rest. cls_gym, which
has an engine, is a wheel of its own: `make wheel`.

Uses grpcio-tools if it is installed (a build by pip installs it), else protoc and
grpc_python_plugin on PATH (Debian: protobuf-compiler, protobuf-compiler-grpc).
"""
import importlib.metadata
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = "cls_playmaker"
INTERFACES = ("playmaker.proto", "team_playmaker.proto")


def interface(name):
    """The file of the repository, or the copy in a source distribution."""
    for path in (HERE / name, HERE.parent / "proto" / name):
        if path.is_file():
            return path
    sys.exit(f"no proto/{name} beside {HERE}: install from a checkout of the repository")


def has_grpc_tools():
    """Whether there are grpcio-tools that write types: from 1.49 on; Debian 12 has 1.14."""
    try:
        version = importlib.metadata.version("grpcio-tools")
    except importlib.metadata.PackageNotFoundError:
        return False
    return [int(part) for part in re.findall(r"\d+", version)[:2]] >= [1, 49]


def generator():
    """The command that runs protoc with its plugin for gRPC."""
    if has_grpc_tools():
        return [sys.executable, "-m", "grpc_tools.protoc"]
    protoc, plugin = shutil.which("protoc"), shutil.which("grpc_python_plugin")
    if protoc and plugin:
        return [protoc, f"--plugin=protoc-gen-grpc_python={plugin}"]
    sys.exit("nothing generates the modules of the wire: install grpcio-tools (pip), or "
             "protobuf-compiler and protobuf-compiler-grpc (Debian)")


OLDEST = {"grpcio": "1.51", "protobuf": "4.21"}


def at_least(name, needed):
    """The oldest version of a package: ours, or a later one that `needed`, lines of pip, asks for."""
    asked = re.search(rf"^{name}\b.*>=\s*(\d+(?:\.\d+)*)", needed, re.MULTILINE)
    versions = [OLDEST[name], *([asked[1]] if asked else [])]
    return f"{name}>=" + max(versions, key=lambda one: [int(part) for part in one.split(".")])


def runtime():
    """The oldest packages that the generated modules run with."""
    tools = importlib.metadata.requires("grpcio-tools") if has_grpc_tools() else None
    return [at_least(name, "\n".join(tools or [])) for name in OLDEST]


def generate(folder):
    """Writes NAME_pb2.py, its types and NAME_pb2_grpc.py into folder/cls_playmaker."""
    with tempfile.TemporaryDirectory() as root:
        # protoc derives the import path of the modules from the path of the file.
        copies = pathlib.Path(root) / PACKAGE
        copies.mkdir()
        for name in INTERFACES:
            shutil.copy(interface(name), copies)
        subprocess.run([*generator(), f"--proto_path={root}", f"--python_out={folder}",
                        f"--pyi_out={folder}", f"--grpc_python_out={folder}",
                        *(str(copies / name) for name in INTERFACES)], check=True)


class BuildWithInterface(build_py):
    def run(self):
        super().run()
        # An editable installation imports from the source tree.
        folder = HERE if getattr(self, "editable_mode", False) else pathlib.Path(self.build_lib)
        folder.mkdir(parents=True, exist_ok=True)
        generate(folder)


class SourceWithInterface(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        for name in INTERFACES:
            shutil.copy(interface(name), base_dir)


setup(install_requires=runtime(),
      cmdclass={"build_py": BuildWithInterface, "sdist": SourceWithInterface})
