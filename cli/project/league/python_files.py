"""Copies what a project in Python needs, besides the interpreter itself: its standard library, and the
packages that the project imports or that its environment has, with what these require.

    python_files.py PROJECT ENVIRONMENT DIR

ENVIRONMENT is a virtual environment or empty. DIR has bin/python3, which starts the copied interpreter.
Prints a line per package: its name and the path that it was copied from."""
import ast
import importlib.metadata
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig

# Without use on a machine that only plays, by name or beginning.
UNUSED = ("test", "idlelib", "tkinter", "turtledemo", "turtle.py", "ensurepip", "lib2to3", "pydoc_data",
          "config-", "site-packages", "dist-packages", "__pycache__", "_tkinter", "_test", "_ctypes_test",
          "_xx", "xx", "_dbm", "_gdbm", "_curses", "_crypt", "EXTERNALLY-MANAGED")
# Packages and distributions that build and install others.
TOOLS = {"pip", "setuptools", "wheel", "pkg_resources", "_distutils_hack", "grpc_tools", "grpcio-tools",
         "mypy_protobuf", "mypy-protobuf"}
LEFT_OUT = shutil.ignore_patterns("__pycache__", "*.pyi", "*.a", "*.h")


def normalized(name):
    return re.sub(r"[-_.]+", "-", name).lower()


def copy(source, target):
    if source.is_dir():
        shutil.copytree(source, target, ignore=LEFT_OUT, dirs_exist_ok=True, ignore_dangling_symlinks=True)
    elif source.exists() and not target.exists():
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, target)


def copy_standard_library(target):
    for entry in pathlib.Path(sysconfig.get_path("stdlib")).iterdir():
        if entry.name == "lib-dynload":
            for module in entry.iterdir():
                if not module.name.startswith(UNUSED):
                    copy(module, target / "lib-dynload" / module.name)
        elif not entry.name.startswith(UNUSED):
            copy(entry, target / entry.name)


def imports_of(files):
    """Names of the packages that files import, with one level below packages without __init__.py."""
    found = set()
    for file in files:
        try:
            tree = ast.parse(file.read_bytes())
        except (SyntaxError, ValueError, OSError):
            continue
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                found.update(alias.name for alias in node.names)
            elif isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
                found.update({node.module, *(f"{node.module}.{alias.name}" for alias in node.names)})
    return found


def sources_below(folder):
    for root, folders, files in os.walk(folder):
        folders[:] = [one for one in folders if one not in ("node_modules", "site-packages")
                      and not os.path.exists(os.path.join(root, one, "pyvenv.cfg"))]
        yield from (pathlib.Path(root, file) for file in files if file.endswith(".py"))


class Packages:
    """Packages outside of the standard library, by the name that import gives them."""

    def __init__(self):
        self.owner = {}      # "numpy": its distribution
        self.by_name = {}    # the distribution by its own name
        self.found = {}      # "google.protobuf": where it is
        self.distributions = set()
        for distribution in importlib.metadata.distributions():
            name = distribution.metadata["Name"]
            if not name or normalized(name) in self.by_name:
                continue
            self.by_name[normalized(name)] = distribution
            for top in self.tops_of(distribution):
                self.owner.setdefault(top, distribution)

    @staticmethod
    def tops_of(distribution):
        """First parts of its files, two where the first is shared with other distributions."""
        base = pathlib.Path(distribution.locate_file(""))
        declared = (distribution.read_text("top_level.txt") or "").split()
        files = [file.parts for file in distribution.files or [] if file.parts[0] not in ("..", "__pycache__")]
        tops = {parts[0] for parts in files if (base / parts[0]).exists()} or set(declared)
        for top in sorted(tops):
            folder = base / top
            if folder.is_dir() and not (folder / "__init__.py").exists() and not top.endswith(
                    (".libs", ".dist-info", ".egg-info")):
                below = {parts[1] for parts in files if parts[0] == top and len(parts) > 1}
                below = below or {one.name for one in folder.iterdir() if one.is_dir()}
                yield from (f"{top}.{one.removesuffix('.py')}" for one in below)
            else:
                yield top.removesuffix(".py")

    def add(self, name):
        """The package of an imported name, such as google.protobuf.message, and what it requires."""
        parts = name.split(".")
        if parts[0] in TOOLS:
            return
        for depth in (1, 2):
            short = ".".join(parts[:depth])
            if short in self.found:
                return
            if short in self.owner:
                self.add_distribution(self.owner[short])
                return
        try:
            spec = importlib.util.find_spec(parts[0])
        except (ImportError, ValueError):
            spec = None
        if spec is not None and spec.origin not in ("built-in", "frozen"):
            self.add_module(parts[0], spec)

    def add_module(self, name, spec):
        places = [pathlib.Path(one) for one in spec.submodule_search_locations or [spec.origin]]
        standard = pathlib.Path(sysconfig.get_path("stdlib"))
        relative = places[0].relative_to(standard).parts if places[0].is_relative_to(standard) else None
        if len(places) != 1 or relative and relative[0] not in ("site-packages", "dist-packages"):
            return
        self.found[name] = places[0]
        files = sources_below(places[0]) if places[0].is_dir() else places
        for imported in imports_of(files):
            self.add(imported)

    def add_distribution(self, distribution):
        name = normalized(distribution.metadata["Name"])
        if name in self.distributions:
            return
        self.distributions.add(name)
        base = pathlib.Path(distribution.locate_file(""))
        declared = set(self.tops_of(distribution))
        for top in declared:
            path = base / pathlib.Path(*top.split(".", 1))
            for place in (path, path.with_name(path.name + ".py"), *path.parent.glob(f"{path.name}.*.so"),
                          *path.parent.glob(f"{path.name}.libs")):
                if place.exists():
                    self.found[str(place.relative_to(base))] = place
        information = getattr(distribution, "_path", None)
        if information is not None and information.is_dir():
            self.found[information.name] = pathlib.Path(information)
        for requirement in distribution.requires or []:
            if "extra ==" in requirement:
                continue
            required = self.by_name.get(normalized(re.match(r"[\w.-]+", requirement)[0]))
            if required is not None and normalized(required.metadata["Name"]) not in TOOLS:
                self.add_distribution(required)


def add_environment(packages, environment):
    for name, distribution in packages.by_name.items():
        base = pathlib.Path(distribution.locate_file("")).resolve()
        if name not in TOOLS and base.is_relative_to(environment):
            packages.add_distribution(distribution)
    for site in environment.glob("lib/python3*/site-packages"):
        for entry in site.iterdir():
            if (entry / "__init__.py").exists() or entry.suffix in (".py", ".so"):
                packages.add(entry.name.split(".")[0])


def main():
    project, environment, target = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    library = target / "lib" / f"python{sys.version_info[0]}.{sys.version_info[1]}"
    copy_standard_library(library)

    python = str(target / "bin/python3")
    sites = subprocess.run([python, "-c", "import site; print('\\n'.join(site.getsitepackages()))"],
                           check=True, capture_output=True, text=True).stdout.split()
    inside = [site for site in sites if pathlib.Path(site).is_relative_to(target)]
    site = pathlib.Path(inside[-1])

    packages = Packages()
    environment = pathlib.Path(environment).resolve() if environment else None
    if environment:
        add_environment(packages, environment)
    for name in sorted(imports_of(sources_below(project))):
        packages.add(name)
    for name, place in sorted(packages.found.items()):
        relative = pathlib.Path(name)
        copy(place, site / (relative if place.is_dir() else relative.with_name(place.name)))
        print(f"{name}\t{place}")

    # The folder may be read-only there, and hashes are not compared, so dates do not matter.
    subprocess.run([python, "-m", "compileall", "-q", "--invalidation-mode", "unchecked-hash", str(target / "lib")],
                   check=False, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
