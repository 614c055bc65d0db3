#!/usr/bin/env python3
"""Builds the documentation as a site from README.md, CHANGELOG.md, docs/ and what they link to, and checks its links.

    packaging/site/build.py build/site           exit code 77: skipped, because mkdocs is missing
    packaging/site/build.py --check build/site   only checks the links

The site needs neither network nor server, its search included. Where `make playground` has built the page that plays
matches, the site has it, too, in playground/, and the tutorial links to its steps; the page needs a web server.
--page DIR takes it from another folder.
"""
from __future__ import annotations

import argparse
import html.parser
import json
import os
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

try:
    import mkdocs.commands.build
    import mkdocs.config
except ImportError:
    # A Python beside the system's has none of Debian's packages.
    SYSTEM = "/usr/bin/python3"
    if os.path.exists(SYSTEM) and os.path.realpath(SYSTEM) != os.path.realpath(sys.executable):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    print("site skipped: no mkdocs (apt-get install mkdocs)")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NAVIGATION = [
    {"Start": [{"Overview": "README.md"}, "docs/install.md", "docs/tutorial.md", "docs/tutorial-2.md", "docs/playmaker-guide.md", "docs/cookbook.md", "docs/cookbook-csharp.md", "docs/cookbook-javascript.md", "docs/migrating.md", "docs/troubleshooting.md"]},
    {"Play": ["docs/matches.md", "docs/watching.md", "docs/reports.md", "docs/review.md", "docs/testing.md", "docs/tournaments.md", "docs/league.md", "docs/tuning.md", "docs/training.md",
              "docs/playground.md", "docs/checks.md", "docs/doctor.md", "docs/cli.md"]},
    {"Interface": ["docs/wire.md", "docs/actions.md", "docs/world-model.md", "docs/formations.md", "docs/mock.md", "docs/strength.md", "docs/reference"]},
    {"Inside": ["docs/server.md", "docs/network.md", "docs/reliability.md", "docs/security.md", "docs/architecture.md", "docs/glossary.md", "docs/formats",
                "docs/spec", "CHANGELOG.md"]},
]
PAGE = ROOT / "build-playground/page"
STEP = "<!-- a step of the page -->"
LINK = re.compile(r"(!?\[[^\]\n]*\])\(([^)\s]+)\)")


def tracked_files() -> set[str]:
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], check=True, capture_output=True, text=True)
    return {name for name in listed.stdout.split("\n") if (ROOT / name).is_file()}


def first_pages(tracked: set[str]) -> list[str]:
    return [name for name in sorted(tracked) if name in ("README.md", "CHANGELOG.md") or (name.startswith("docs/") and name.endswith(".md"))]


def split_target(page: str, target: str) -> tuple[str, str]:
    """The file of a link, from the root of the repository ("" outside it), and its anchor."""
    path, _, anchor = target.partition("#")
    if not path or re.match(r"[a-z]+:", target):
        return "", anchor
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), path)), anchor


class Stage:
    """A folder with the sources of the site, laid out as the repository; with links to steps of the page if the site has it."""

    def __init__(self, folder: pathlib.Path, with_page: bool) -> None:
        self.folder = folder
        self.with_page = with_page
        self.tracked = tracked_files()
        self.folders = {str(parent) for name in self.tracked for parent in pathlib.PurePosixPath(name).parents} - {"."}
        self.done: set[str] = set()
        self.broken: list[str] = []

    def add(self, name: str) -> None:
        if name in self.done:
            return
        self.done.add(name)
        to = self.folder / name
        to.parent.mkdir(parents=True, exist_ok=True)
        if not name.endswith(".md"):
            shutil.copyfile(ROOT / name, to)
            return
        text = (ROOT / name).read_text(encoding="utf-8")
        if self.with_page:
            text = with_step_links(name, text)
        to.write_text(readable(self.follow_links(name, text)), encoding="utf-8")

    def add_folder(self, name: str) -> str:
        """A page about a folder: its README, or a list of its files."""
        if f"{name}/README.md" in self.tracked:
            self.add(f"{name}/README.md")
            return f"{name}/README.md"
        page = f"{name}/index.md"
        if page not in self.done:
            self.done.add(page)
            files = sorted(each for each in self.tracked if posixpath.dirname(each) == name)
            for each in files:
                self.add(each)
            lines = [f"# {name}", ""] + [f"- [{posixpath.basename(each)}]({posixpath.basename(each)})" for each in files]
            (self.folder / page).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / page).write_text("\n".join(lines) + "\n", encoding="utf-8")
        return page

    def follow_links(self, page: str, text: str) -> str:
        def follow(match: re.Match[str]) -> str:
            file, anchor = split_target(page, match[2])
            if not file:
                return match[0]
            if file in self.tracked:
                self.add(file)
                return match[0]
            if file not in self.folders:
                self.broken.append(f"{page}: ({match[2]}): no such file")
                return match[0]
            target = posixpath.relpath(self.add_folder(file), posixpath.dirname(page) or ".")
            return f"{match[1]}({target}{'#' + anchor if anchor else ''})"

        lines = text.split("\n")
        fenced = False
        for i, line in enumerate(lines):
            fenced ^= line.lstrip().startswith("```")
            if not fenced:
                lines[i] = LINK.sub(follow, line)
        return "\n".join(lines)


def with_step_links(page: str, text: str) -> str:
    """A link in the place of each mark of a step, which has the name of its heading."""
    to_page = posixpath.relpath("playground/index.html", posixpath.dirname(page))
    lines = text.split("\n")
    heading = ""
    for i, line in enumerate(lines):
        if line.startswith("## "):
            heading = github_slug(line[3:], "-")
        elif line == STEP:
            lines[i] = f'<p class="step"><a href="{to_page}#learn={heading}">Try this step in the browser</a></p>\n'
    return "\n".join(lines)


def readable(text: str) -> str:
    """What GitHub takes for lists and code in lists, as Python's Markdown wants them."""
    lines: list[str] = []
    fence = -1  # indentation of the open one
    for line in text.split("\n"):
        indent = len(line) - len(line.lstrip())
        item = re.match(r" *([-*]|\d+\.) ", line)
        if line.lstrip().startswith("```"):
            if fence < 0 and indent > 0:
                lines.append("")
            fence = indent if fence < 0 else -1
            if indent == 0 and "```" in line:
                lines.append(line)
            continue
        if fence > 0:
            lines.append(" " * 8 + line[fence:] if line.strip() else "")
        elif fence == 0:
            lines.append(line)
        else:
            before = lines[-1] if lines else ""
            if item and before.strip() and not re.match(r" *([-*]|\d+\.) ", before) and not in_list(lines):
                lines.append("")
            if 2 <= indent < 4 and (item or (not before.strip() and in_list(lines))):
                line = " " * (4 - indent) + line
            lines.append(line)
    return "\n".join(lines)


def in_list(lines: list[str]) -> bool:
    """Whether the last lines belong to an item of a list."""
    for line in reversed(lines):
        if re.match(r" *([-*]|\d+\.) ", line):
            return True
        if line and not line.startswith(" "):
            return False
    return False


def github_slug(text: str, separator: str) -> str:
    kept = "".join(c for c in text.strip().lower() if c.isalnum() or c in " _-")
    return kept.replace(" ", separator)


def expanded(entries: list, stage: Stage) -> list:
    """The navigation with the pages of its folders."""
    result: list = []
    for entry in entries:
        if isinstance(entry, dict):
            result += [{title: pages if isinstance(pages, str) else expanded(pages, stage)} for title, pages in entry.items()]
        elif entry.endswith(".md"):
            result.append(entry)
        else:
            pages = sorted(name for name in stage.done if posixpath.dirname(name) == entry and name.endswith(".md"))
            result.append({posixpath.basename(entry).capitalize(): pages})
    return result


def write_site(stage: Stage, out: pathlib.Path) -> None:
    # Without a file of its own, mkdocs would look for one in the working directory.
    config_file = stage.folder.parent / "mkdocs.yml"
    config_file.write_text("site_name: cls\n", encoding="utf-8")
    config = mkdocs.config.load_config(
        config_file=str(config_file), site_name="cls", docs_dir=str(stage.folder), site_dir=str(out), use_directory_urls=False,
        theme={"name": None, "custom_dir": str(ROOT / "packaging/site/theme")}, plugins=[], nav=expanded(NAVIGATION, stage),
        extra={"page": stage.with_page},
        markdown_extensions=["tables", "fenced_code", "sane_lists", {"toc": {"slugify": github_slug, "permalink": True}}])
    mkdocs.commands.build.build(config)
    for path in out.rglob("*.html"):  # keys scroll wide code, too
        path.write_text(path.read_text(encoding="utf-8").replace("<pre>", '<pre tabindex="0">'), encoding="utf-8")


def add_page(page: pathlib.Path, site: pathlib.Path) -> None:
    """Copies the page that plays matches, and tells it where the tutorial is."""
    shutil.rmtree(site / "playground", ignore_errors=True)
    shutil.copytree(page, site / "playground")
    index = site / "playground/index.html"
    text = index.read_text(encoding="utf-8")
    filled = text.replace('<meta name="documentation" content="">', '<meta name="documentation" content="../docs/">')
    if filled == text:
        raise SystemExit(f"{page / 'index.html'} has no place for the address of the documentation: make playground")
    index.write_text(filled, encoding="utf-8")


class Sections(html.parser.HTMLParser):
    """The text of a page by heading, for its search."""

    def __init__(self, url: str, text: str) -> None:
        super().__init__()
        self.sections: list[dict[str, str]] = []
        self.url = url
        self.depth = 0  # inside <article>
        self.heading = False
        self.page = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.depth += tag == "article"
        if self.depth and tag in ("h1", "h2", "h3"):
            self.heading = True
            self.sections.append({"url": f"{self.url}#{dict(attrs).get('id') or ''}", "title": "", "text": ""})

    def handle_endtag(self, tag: str) -> None:
        self.depth -= tag == "article"
        if not self.heading or tag not in ("h1", "h2", "h3"):
            return
        self.heading = False
        if tag == "h1":
            self.page = self.sections[-1]["title"]
        elif self.page:
            self.sections[-1]["title"] = f"{self.page}: {self.sections[-1]['title']}"

    def handle_data(self, data: str) -> None:
        if not self.depth or not self.sections or data == "\u00b6":
            return
        key = "title" if self.heading else "text"
        self.sections[-1][key] += data.replace("\n", " ")


def write_search_index(site: pathlib.Path) -> None:
    sections = []
    for path in sorted(site.rglob("*.html")):
        url = path.relative_to(site).as_posix()
        sections += Sections(url, path.read_text(encoding="utf-8")).sections
    index = json.dumps(sections, ensure_ascii=False).replace("</", "<\\/")
    (site / "search_index.js").write_text(f"var siteSections = {index};\n", encoding="utf-8")


class Links(html.parser.HTMLParser):
    """Targets of a page, its anchors, and what it loads."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.loads: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        self.anchors |= {found.get("id") or "", found.get("name") or ""}
        if tag == "a" and found.get("href"):
            self.targets.append(found["href"] or "")
        elif tag in ("script", "img") and found.get("src"):
            self.loads.append(found["src"] or "")
        elif tag == "link" and found.get("href") and found.get("rel") != "canonical":
            self.loads.append(found["href"] or "")


def dead_links(site: pathlib.Path) -> list[str]:
    pages = {path: Links(path.read_text(encoding="utf-8")) for path in sorted(site.rglob("*.html"))}
    dead = []
    for path, links in pages.items():
        name = path.relative_to(site)
        dead += [f"{name}: loads {url}, which is not of this site" for url in links.loads if re.match(r"([a-z]+:)?//", url)]
        for target in links.targets + links.loads:
            if re.match(r"([a-z]+:|//)", target) or target in ("#", ".", "/"):
                continue
            file, _, anchor = urllib.parse.unquote(target).partition("#")
            to = path if not file else pathlib.Path(os.path.normpath(path.parent / file.split("?")[0]))
            to = to / "index.html" if to.is_dir() else to
            if not to.is_file():
                dead.append(f"{name}: {target}: no such file")
            elif anchor and "=" not in anchor and to in pages and anchor not in pages[to].anchors:
                dead.append(f"{name}: {target}: no such heading")
    return dead


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("site", nargs="?", default="build/site", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--page", default=PAGE, type=pathlib.Path)
    arguments = parser.parse_args()
    out = arguments.site.resolve()
    if arguments.check:
        return report(out, dead_links(out))

    has_page = (arguments.page / "index.html").is_file()
    with tempfile.TemporaryDirectory() as folder:
        stage = Stage(pathlib.Path(folder) / "pages", has_page)
        for name in first_pages(stage.tracked):
            stage.add(name)
        write_site(stage, out)
    write_search_index(out)
    if has_page:
        add_page(arguments.page, out)
    else:
        print(f"the site has no page that plays matches: no {arguments.page} (make playground)")
    return report(out, stage.broken + dead_links(out))


def report(out: pathlib.Path, dead: list[str]) -> int:
    for line in dead:
        print(line, file=sys.stderr)
    if dead:
        print(f"{out}: {len(dead)} dead links", file=sys.stderr)
        return 1
    print(f"{out / 'index.html'}: {len(list(out.rglob('*.html')))} pages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
