#!/usr/bin/env python3
"""Builds what users install from a release build: `cls` as one file, a Debian package, their bill of
materials, licenses and checksums, in build/dist; with --all also the wheels of the Python packages, with
--wheels these alone, in build/wheels. The same source gives the same bytes."""
import argparse
import email.utils
import gzip
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import zlib

import libraries
import wheels

SOURCE = pathlib.Path(__file__).resolve().parent.parent
ARCHIVES = pathlib.Path("/usr/lib/x86_64-linux-gnu")
SLEEF = ARCHIVES / "libsleef.so.3"
# In place of the shared libraries; the linker takes from archives what is used.
STATIC = ["grpc++_reflection", "grpc++", "grpc", "gpr", "address_sorting", "upb", "re2", "cares",
          "protobuf", "SQLiteCpp", "sqlite3", "ssl", "crypto", "z", "lzma", "zstd"]
# Without an archive in Debian; packaging/ has what takes their place.
REPLACED = {"fmt": "static_fmt", "tomlplusplus": "static_toml", "sleef": "embedded_sleef",
            "glibc": "old_c_library"}
HARDENED = ["-Wl,-z,relro,-z,now", "-Wl,--exclude-libs,ALL", "-static-libstdc++", "-static-libgcc"]
# No symbols, so that the build id does not depend on debug information.
SMALL = ["-Wl,--gc-sections", "-Wl,--strip-all"]
# The oldest C library that starts the program: that of Ubuntu 20.04, where competitions run.
GLIBC = (2, 31)
# The same for the wheel of cls_gym, and its tag: what current installers accept on most systems.
WHEEL_GLIBC = (2, 28)
# Libraries that libc.so.6 absorbed in glibc 2.34, and what names of their functions begin with.
ABSORBED = {"libpthread.so.0": ("pthread_", "__pthread_"), "libdl.so.2": ("dl",)}


def run(*command: object, cwd: pathlib.Path | None = None) -> str:
    done = subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise SystemExit(f"{shlex.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def sleef_functions(build: pathlib.Path) -> str:
    archives = sorted((build / "soccer").glob("libcls_soccer*.a"))
    names = run("nm", "--undefined-only", "--no-sort", *archives)
    return " ".join(f"CLS_SLEEF_FUNCTION({name})" for name in sorted(set(
        re.findall(r"U (Sleef_\w+)", names))))


def compile_replacements(build: pathlib.Path, work: pathlib.Path, names: list[str],
                         *flags: str) -> list[pathlib.Path]:
    compressed = work / "sleef.z"
    compressed.write_bytes(zlib.compress(SLEEF.read_bytes(), 9))
    objects = []
    for name in names:
        objects.append(work / f"{name}.o")
        run("c++", "-std=c++20", "-O2", "-fPIC", "-ffunction-sections", *flags,
            f"-DCLS_SLEEF_FILE=\"{compressed}\"",
            f"-DCLS_SLEEF_SIZE={SLEEF.stat().st_size}",
            f"-DCLS_SLEEF_FUNCTIONS={sleef_functions(build)}", "-c", SOURCE / "packaging" / f"{name}.cpp",
            "-o", objects[-1])
    return objects


def numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def old_versions() -> dict[str, dict[str, list[str]]]:
    """Functions that are newer in libc.so.6 than GLIBC because they moved there: their versions before
    that, by library and version."""
    symbols = run("readelf", "-W", "--dyn-syms", ARCHIVES / "libc.so.6")
    moved = {name for name, version in re.findall(r" (\w+)@@GLIBC_([\d.]+)$", symbols, re.M)
             if numbers(version) > GLIBC}
    found: dict[str, dict[str, list[str]]] = {}
    for name, version in re.findall(r" (\w+)@GLIBC_([\d.]+)$", symbols, re.M):
        for library, beginnings in ABSORBED.items():
            if name in moved and name.startswith(beginnings) and numbers(version) <= GLIBC:
                found.setdefault(library, {}).setdefault(version, []).append(name)
    return found


def old_libraries(work: pathlib.Path) -> list[pathlib.Path]:
    """Libraries without code, with which the linker finds the old version of a function first."""
    libraries_found = []
    for library, versions in old_versions().items():
        names = sorted({name for listed in versions.values() for name in listed})
        source, script, out = work / f"{library}.c", work / f"{library}.map", work / library
        source.write_text("".join(f"void {name}(void) {{}}\n" for name in names))
        # A function with several old versions gets the latest of them.
        seen: set[str] = set()
        text = ""
        for version in sorted(versions, key=numbers, reverse=True):
            names_here = [name for name in sorted(versions[version]) if name not in seen]
            seen.update(names_here)
            if names_here:
                text += f"GLIBC_{version} {{ {' '.join(f'{name};' for name in names_here)} }};\n"
        script.write_text(text)
        run("cc", "-shared", "-nostdlib", "-fno-builtin", "-w", f"-Wl,-soname,{library}",
            f"-Wl,--version-script={script}", source, "-o", out)
        libraries_found.append(out)
    return libraries_found


def link(build: pathlib.Path, target: str, out: pathlib.Path, replacements: list[pathlib.Path]) -> None:
    """Links `target` again, with archives in place of Debian's shared libraries."""
    command = run("ninja", "-C", build, "-t", "commands", "-s", target).strip().splitlines()[-1]
    words = shlex.split(command.removeprefix(": && ").removesuffix(" && :"))
    shared = re.compile(r"/lib[\w+-]+\.so[\d.]*$|^-l|^-Wl,-rpath")
    inputs = words.index("-o") + 2
    kept = [word for word in words[inputs:] if not shared.search(word)]
    options = [word for word in words[:inputs - 1] if not shared.search(word)]
    # Programs of the group need each other in both directions.
    archives = [ARCHIVES / f"lib{name}.a" for name in STATIC]
    archives += sorted(ARCHIVES.glob("libabsl_*.a"))
    # Libraries have no __libc_start_main.
    start = [] if "-shared" in options else ["-Wl,--wrap=__libc_start_main"]
    run(*options, out, *HARDENED, *SMALL, *start, "-Wl,--start-group", *kept,
        *replacements, *archives, "-Wl,--end-group", "-Wl,--no-as-needed", *old_libraries(replacements[0].parent),
        "-Wl,--as-needed", "-lm", cwd=build)
    run("strip", "--remove-section=.comment", out)


def stage(build: pathlib.Path, root: pathlib.Path, program: pathlib.Path, library: pathlib.Path,
          licenses: pathlib.Path, version: str) -> None:
    """The files of the Debian package."""
    os.environ["DESTDIR"] = str(root)
    run("cmake", "--install", build, "--prefix", "/usr")
    del os.environ["DESTDIR"]
    usr = root / "usr"
    shutil.copy(program, usr / "bin/cls")
    [installed] = [path for path in usr.rglob("libcls_training.so.1")]
    shutil.copyfile(library, installed)
    installed.chmod(0o644)
    packages = usr / "lib/python3/dist-packages"
    packages.parent.mkdir(parents=True, exist_ok=True)
    (usr / "share/cls/python").rename(packages)
    engine = packages / "cls_gym/libcls_training.so"
    engine.unlink()
    engine.symlink_to(os.path.relpath(installed, engine.parent))
    complete_for_debian(usr, licenses, version)


def complete_for_debian(usr: pathlib.Path, licenses: pathlib.Path, version: str) -> None:
    debian = SOURCE / "packaging/debian"
    pages = usr / "share/doc/cls"
    (usr / "share/lintian/overrides").mkdir(parents=True)
    shutil.copyfile(debian / "lintian-overrides", usr / "share/lintian/overrides/cls")
    shutil.copyfile(debian / "copyright", pages / "copyright")
    (pages / "LICENSE").unlink()
    date = email.utils.formatdate(int(os.environ["SOURCE_DATE_EPOCH"]))
    (pages / "changelog").write_text(
        f"cls ({version}) unstable; urgency=medium\n\n  * See CHANGELOG.md.\n\n"
        f" -- the cls maintainers <cls@localhost.localdomain>  {date}\n")
    shutil.copyfile(licenses, pages / "LIBRARIES")
    for page in [pages / "changelog", pages / "LIBRARIES", *usr.glob("share/man/man1/*.1")]:
        with open(f"{page}.gz", "wb") as out, gzip.GzipFile("", "wb", 9, out, mtime=0) as packed:
            packed.write(page.read_bytes())
        page.unlink()


def newest_symbol(file: pathlib.Path) -> tuple[int, ...]:
    """The newest version of glibc that a program or library needs."""
    return max(map(numbers, re.findall(r"GLIBC_(\d[\d.]*)", run("readelf", "-W", "-V", file))))


def link_engine(build: pathlib.Path, work: pathlib.Path) -> pathlib.Path:
    """The engine of cls_gym for old systems, too."""
    own = work / "engine"
    own.mkdir(exist_ok=True)
    library = own / "libcls_training.so.1"
    link(build, "lib/libcls_training.so.1", library,
         compile_replacements(build, own, [REPLACED[one] for one in ("fmt", "sleef", "glibc")],
                              "-DCLS_SLEEF_IN_LIBRARY"))
    needed = newest_symbol(library)
    if needed > WHEEL_GLIBC:
        raise SystemExit(f"{library}: needs glibc {'.'.join(map(str, needed))}, wheels are tagged "
                         f"{wheel_platform()}")
    return library


def wheel_platform() -> str:
    return "manylinux_{}_{}_x86_64".format(*WHEEL_GLIBC)


def write_wheels(build: pathlib.Path, version: str, epoch: int, engine: pathlib.Path,
                 platform: str, dist: pathlib.Path) -> None:
    for path in dist.glob("*.whl"):  # of other versions
        path.unlink()
    for path in wheels.write_all(build, version, engine, platform, epoch, dist):
        print(f"{path.stat().st_size:>10}  {path}")


def tree_of_same_age(root: pathlib.Path, epoch: int) -> None:
    for path in [root, *root.rglob("*")]:
        if path.is_symlink():
            os.utime(path, (epoch, epoch), follow_symlinks=False)
            continue
        runs = path.is_dir() or path.stat().st_mode & 0o100
        path.chmod(0o755 if runs else 0o644)
        os.utime(path, (epoch, epoch))


def source_date() -> int:
    """SOURCE_DATE_EPOCH, which is set: by the caller, or to the date of the commit, or of the file of
    changes where there is no repository."""
    if "SOURCE_DATE_EPOCH" not in os.environ:
        done = subprocess.run(["git", "-C", str(SOURCE), "log", "-1", "--format=%ct"],
                              capture_output=True, text=True, check=False)
        changed = int((SOURCE / "CHANGELOG.md").stat().st_mtime)
        os.environ["SOURCE_DATE_EPOCH"] = done.stdout.strip() or str(changed)
    return int(os.environ["SOURCE_DATE_EPOCH"])


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=SOURCE / "build")
    parser.add_argument("--out", type=pathlib.Path,
                        help="folder of the files (default: BUILD/dist, or BUILD/wheels)")
    parser.add_argument("--all", action="store_true", help="the wheels, too")
    parser.add_argument("--wheels", action="store_true", help="the wheels alone")
    parser.add_argument("--as-built", action="store_true",
                        help="with --wheels: the engine as it is in BUILD, for this system alone")
    return parser.parse_args()


def make_wheels(build: pathlib.Path, version: str, epoch: int, as_built: bool,
                dist: pathlib.Path) -> None:
    dist.mkdir(parents=True, exist_ok=True)
    if as_built:
        write_wheels(build, version, epoch, build / "lib/libcls_training.so.1", "linux_x86_64", dist)
        return
    with tempfile.TemporaryDirectory(dir=build) as work:
        engine = link_engine(build, pathlib.Path(work))
        write_wheels(build, version, epoch, engine, wheel_platform(), dist)


def make_files(build: pathlib.Path, version: str, epoch: int, with_wheels: bool,
               dist: pathlib.Path) -> None:
    work = dist.with_name("package")
    for folder in (work, dist):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
    name = f"cls-{version}-linux-x86_64"

    program, library = dist / name, link_engine(build, work)
    link(build, "bin/cls", program, compile_replacements(build, work, [*REPLACED.values()]))
    libraries.write(program, version, epoch, STATIC, dist)

    stage(build, work / "root", program, library, dist / f"{name}.licenses.txt",
          version)
    tree_of_same_age(work / "root", epoch)
    os.environ["CLS_ROOT"] = str(work / "root")
    run("cpack", "--config", SOURCE / "packaging/debian/cpack.cmake", "-D",
        f"CPACK_PACKAGE_VERSION={version}", "-B", work)
    [package] = work.glob("*.deb")
    package.rename(dist / package.name)

    if with_wheels:
        write_wheels(build, version, epoch, library, wheel_platform(), dist)

    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n"
             for path in sorted(dist.iterdir())]
    (dist / "SHA256SUMS").write_text("".join(lines))
    for path in sorted(dist.iterdir()):
        print(f"{path.stat().st_size:>10}  {path}")


def main() -> None:
    arguments = parse()
    build = arguments.build.resolve()
    dist = (arguments.out or build / ("wheels" if arguments.wheels else "dist")).resolve()
    epoch = source_date()
    cache = (build / "CMakeCache.txt").read_text()
    version = re.search(r"^CMAKE_PROJECT_VERSION:STATIC=(.*)$", cache, re.M)[1]
    if arguments.wheels:
        make_wheels(build, version, epoch, arguments.as_built, dist)
    else:
        make_files(build, version, epoch, arguments.all, dist)


if __name__ == "__main__":
    main()
