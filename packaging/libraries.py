"""The libraries in a statically linked `cls`: an SPDX bill of materials and their licenses, from
Debian's database of packages."""
import datetime
import hashlib
import json
import pathlib
import re
import subprocess

ARCHIVES = "/usr/lib/x86_64-linux-gnu/lib{}.a"
# Libraries of headers only, and what the linker takes from elsewhere.
OTHERS = ["libabsl-dev", "libboost-dev", "libcli11-dev", "libfmt-dev", "libgcc-12-dev", "libsleef3",
          "libstdc++-12-dev", "libtomlplusplus-dev", "nlohmann-json3-dev"]
KEYS = ("name", "version", "source", "source_version", "homepage")
FORM = "${Package}\t${Version}\t${source:Package}\t${source:Version}\t${Homepage}\n"


def _output(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def _packages(archives: list[str]) -> list[dict[str, str]]:
    found = _output("dpkg-query", "-S", *(ARCHIVES.format(name) for name in archives))
    names = {line.split(":")[0] for line in found.splitlines()}
    rows = _output("dpkg-query", "-W", "-f", FORM, *sorted(names | set(OTHERS)))
    return [dict(zip(KEYS, row.split("\t"))) for row in rows.splitlines()]


def _spdx_package(package: dict[str, str]) -> dict[str, object]:
    return {
        "SPDXID": "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", package["name"]),
        "name": package["source"], "versionInfo": package["source_version"],
        "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION",
        "copyrightText": "NOASSERTION", "homepage": package["homepage"] or "NOASSERTION",
        "comment": f"from Debian's package {package['name']} {package['version']}",
        "externalRefs": [{
            "referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
            "referenceLocator": f"pkg:deb/debian/{package['source']}@{package['source_version']}"
                                "?arch=source"}]}


def _spdx(program: pathlib.Path, version: str, epoch: int,
          packages: list[dict[str, str]]) -> dict[str, object]:
    digest = hashlib.sha256(program.read_bytes()).hexdigest()
    created = datetime.datetime.fromtimestamp(epoch, datetime.timezone.utc)
    listed = [_spdx_package(package) for package in packages]
    cls = {"SPDXID": "SPDXRef-cls", "name": "cls", "versionInfo": version,
           "packageFileName": program.name, "downloadLocation": "NOASSERTION",
           "filesAnalyzed": False, "licenseConcluded": "MIT", "licenseDeclared": "MIT",
           "copyrightText": "2026 the cls maintainers",
           "checksums": [{"algorithm": "SHA256", "checksumValue": digest}]}
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", "SPDXRef-cls")]
    relations += [("SPDXRef-cls", "STATIC_LINK", str(one["SPDXID"])) for one in listed]
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": program.name,
        "documentNamespace": f"https://spdx.org/spdxdocs/{program.name}-{digest}",
        "creationInfo": {"created": created.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": ["Tool: packaging/build.py"]},
        "packages": [cls, *listed],
        "relationships": [{"spdxElementId": one, "relationshipType": kind,
                           "relatedSpdxElement": other} for one, kind, other in relations]}


def write(program: pathlib.Path, version: str, epoch: int, archives: list[str],
          folder: pathlib.Path) -> None:
    """Writes PROGRAM.spdx.json and PROGRAM.licenses.txt into `folder`."""
    packages = _packages(archives)
    document = _spdx(program, version, epoch, packages)
    (folder / f"{program.name}.spdx.json").write_text(json.dumps(document, indent=2) + "\n")
    text = "The program cls contains code of these libraries, under the licenses below.\n"
    for package in packages:
        terms = pathlib.Path("/usr/share/doc", package["name"], "copyright").read_text()
        text += f"\n{'=' * 78}\n{package['source']} {package['source_version']}\n\n{terms}"
    (folder / f"{program.name}.licenses.txt").write_text(text)
