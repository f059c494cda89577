#!/usr/bin/python3
"""Makes the documentation site: pages of docs/, the API of the Python module, that of C++.

    make_site.py SOURCE BUILD [--doxygen PROGRAM]

SOURCE is the source tree, BUILD a folder that is made anew; the site is BUILD/html. A link to a page,
a file or an anchor that is not there is an error. Formulas are drawn by MathJax, which the site has a copy of.
"""

import argparse
import ast
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Pages of the site that are elsewhere in the source tree.
ELSEWHERE = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
}
# Folders of headers that others include.
LIBRARIES = ("core mesh shapes reconstruct massprops classify dem terrain library pipeline study "
             "report").split()  # fmt: skip

# MathJax 2 (Debian: libjs-mathjax), and what TeX drawn as SVG needs of it.
MATHJAX = Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ("MathJax.js config/TeX-AMS_SVG.js extensions jax/element jax/input/TeX jax/output/SVG/jax.js "
                 "jax/output/SVG/config.js jax/output/SVG/autoload jax/output/SVG/fonts/TeX").split()  # fmt: skip


def relink(text, folder, source, pages, page):
    """Links of a file in `folder` of the source tree, as links of `page` of the site."""
    up = "../" * page.count("/")

    def target(match):
        place, anchor = match[2], match[3] or ""
        if re.match(r"[a-z]+:", place) or not place:
            return match[0]
        file = (folder / place).resolve()
        if not file.exists():
            raise SystemExit(f"error: a link to {place} in {folder}: no such file")
        inner = file.relative_to(source)
        if file in pages:
            return f"{match[1]}{up}{pages[file]}{anchor})"
        if file.suffix in (".png", ".svg"):
            return f"{match[1]}{up}{file.name})"
        if inner == Path("docs/references.bib"):
            return f"{match[1]}{up}references.md)"
        return f"{match[1]}{up}files/{inner.as_posix()})"

    return re.sub(r"(\]\()([^)#\s]*)(#[^)\s]*)?\)", target, text)


def write_pages(source, pages_folder):
    """Copies pages, pictures, and what pages link to."""
    docs = source / "docs"
    pages = {file: file.relative_to(docs).as_posix() for file in sorted(docs.rglob("*.md"))}
    pages |= {source / name: page for name, page in ELSEWHERE.items()}
    for file, page in pages.items():
        text = relink(file.read_text(encoding="utf-8"), file.parent, source, pages, page)
        (pages_folder / page).parent.mkdir(exist_ok=True)
        (pages_folder / page).write_text(text, encoding="utf-8")
        for linked in re.findall(r"\]\((?:\.\./)*files/([^)]+)\)", text):
            if (source / linked).is_file():
                copy = pages_folder / "files" / linked
                copy.parent.mkdir(parents=True, exist_ok=True)
                # As text: a Markdown file would become a page of its own.
                copy = copy.with_name(copy.name + ".txt") if copy.suffix == ".md" else copy
                shutil.copy(source / linked, copy)
    for page in pages.values():  # links to what was renamed
        file = pages_folder / page
        text = re.sub(r"(\]\((?:\.\./)*files/[^)]+\.md)\)", r"\1.txt)", file.read_text(encoding="utf-8"))
        file.write_text(text, encoding="utf-8")
    docs_pictures = (file for ending in ("png", "svg") for file in sorted(docs.rglob("*." + ending)))
    for picture in docs_pictures:
        shutil.copy(picture, pages_folder)
    bib = (source / "docs" / "references.bib").read_text(encoding="utf-8")
    (pages_folder / "references.md").write_text(f"# References\n\n```bibtex\n{bib}\n```\n", encoding="utf-8")


def write_mathjax(source, pages_folder):
    """Copies MathJax and its settings, so that formulas are drawn without a network."""
    if not (MATHJAX / "MathJax.js").exists():
        raise SystemExit(f"error: no MathJax in {MATHJAX} (on Debian: apt install libjs-mathjax)")
    for part in MATHJAX_PARTS:
        copy = pages_folder / "mathjax" / part
        copy.parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if (MATHJAX / part).is_dir() else shutil.copy)(MATHJAX / part, copy)
    shutil.copy(source / "docs" / "site" / "mathjax_settings.js", pages_folder / "mathjax" / "settings.js")


def signature(node):
    text = ast.unparse(node.args)
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}({text}){returns}"


def documented(node, level):
    """Lines about a class or function of the module."""
    lines = [f"{'#' * level} {node.name}\n"]
    if isinstance(node, ast.FunctionDef):
        lines.append(f"```python\n{signature(node)}\n```\n")
    if doc := ast.get_docstring(node):
        lines.append(f"```text\n{doc}\n```\n")
    if isinstance(node, ast.ClassDef):
        for member in node.body:
            if isinstance(member, ast.AnnAssign) and not member.target.id.startswith("_"):
                lines.append(f"- `{member.target.id}: {ast.unparse(member.annotation)}`\n")
            if isinstance(member, ast.FunctionDef) and not member.name.startswith("_"):
                lines += documented(member, level + 1)
    return lines


def write_python_api(source, pages_folder):
    """Of every public name of the module: its signature and docstring, from sources and stubs."""
    package = source / "python" / "package"
    init = ast.parse((package / "__init__.py").read_text(encoding="utf-8"))
    public = {}  # name: the file that it is from
    for node in init.body:
        if isinstance(node, ast.ImportFrom):
            for name in node.names:
                public[name.asname or name.name] = node.module.split(".")[-1]
    lines = ["# Python module\n", f"```text\n{ast.get_docstring(init)}\n```\n"]
    for name in sorted(public, key=str.lower):
        if name.startswith("_"):
            continue
        file = package / f"{public[name]}.py"
        file = file if file.exists() else package / f"{public[name]}.pyi"
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and node.name == name:
                lines += documented(node, 2)
    (pages_folder / "api").mkdir()
    (pages_folder / "api" / "python.md").write_text("\n".join(lines), encoding="utf-8")


def write_cpp_api(source, pages_folder, doxygen):
    settings = f"""
PROJECT_NAME = clast
INPUT = {" ".join(str(source / folder) for folder in LIBRARIES)}
FILE_PATTERNS = *.hpp
RECURSIVE = YES
EXCLUDE_PATTERNS = */detail/*
EXCLUDE_SYMBOLS = *_detail
STRIP_FROM_PATH = {source}
EXTRACT_ALL = YES
OUTPUT_DIRECTORY = {pages_folder / "api"}
HTML_OUTPUT = cpp
GENERATE_LATEX = NO
QUIET = YES
WARNINGS = NO
CITE_BIB_FILES =
ALIASES = "cite=Source:"
"""
    subprocess.run([doxygen, "-"], input=settings, text=True, check=True)


class Links(HTMLParser):
    def __init__(self):
        super().__init__()
        self.anchors, self.links = set(), []

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)
            if name == "href" and tag == "a" and value is not None:
                self.links.append(value)


def broken_links(html):
    """Links of pages to files and anchors that are not there."""
    pages = {}
    for file in html.rglob("*.html"):
        if "cpp" in file.relative_to(html).parts or file.name == "404.html":
            continue
        pages[file] = Links()
        pages[file].feed(file.read_text(encoding="utf-8"))
    broken = []
    for file, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            if not target.exists():
                broken.append(f"{file.relative_to(html)}: {link}: no such file")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors:
                broken.append(f"{file.relative_to(html)}: {link}: no such anchor")
    return sorted(set(broken)), sum(len(page.links) for page in pages.values())


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("source", type=Path)
    arguments.add_argument("build", type=Path)
    arguments.add_argument("--doxygen")
    given = arguments.parse_args()
    source, build = given.source.resolve(), given.build.resolve()
    shutil.rmtree(build, ignore_errors=True)
    pages_folder = build / "pages"
    pages_folder.mkdir(parents=True)
    write_pages(source, pages_folder)
    write_mathjax(source, pages_folder)
    write_python_api(source, pages_folder)
    settings = (source / "docs" / "site" / "mkdocs.yml").read_text(encoding="utf-8")
    if given.doxygen:
        write_cpp_api(source, pages_folder, given.doxygen)
        settings += "      - C++ libraries: api/cpp/index.html\n"
    (build / "mkdocs.yml").write_text(settings, encoding="utf-8")
    shutil.copy(source / "docs" / "site" / "github_slug.py", build)
    made = subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet"], cwd=build,
                          env={"PYTHONPATH": str(build), "PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8",
                               "HOME": str(build)})  # fmt: skip
    if made.returncode:
        sys.exit("error: mkdocs refused the pages; its messages are above")
    broken, checked = broken_links(build / "html")
    for line in broken:
        print(f"error: {line}", file=sys.stderr)
    if broken:
        sys.exit(1)
    print(f"{build / 'html' / 'index.html'}: {checked} links checked")


if __name__ == "__main__":
    main()
