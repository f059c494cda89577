"""The site is made, what is broken in it is found, and the commands of its pages are the program's."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[2]
PARTS = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "docs", "samples", "python/package")


def make(source, build):
    return subprocess.run([sys.executable, source / "docs" / "site" / "make_site.py", source, build],
                          capture_output=True, text=True)  # fmt: skip


@pytest.fixture
def copy(tmp_path):
    """What the site is made of, to be damaged."""
    pytest.importorskip("mkdocs", reason="mkdocs is not installed")
    if not Path("/usr/share/javascript/mathjax/MathJax.js").exists():
        pytest.skip("MathJax is not installed")
    for part in PARTS:
        original = SOURCE / part
        target = tmp_path / "source" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if original.is_dir() else shutil.copy)(original, target)
    return tmp_path / "source"


def test_the_site_has_every_page_and_no_broken_link(copy, tmp_path):
    done = make(copy, tmp_path / "site")
    assert done.returncode == 0, done.stderr
    assert int(re.search(r"(\d+) links checked", done.stdout)[1]) > 500
    html = tmp_path / "site" / "html"
    for page in (SOURCE / "docs").rglob("*.md"):
        assert (html / page.relative_to(SOURCE / "docs")).with_suffix(".html").exists(), page
    api = (html / "api" / "python.html").read_text(encoding="utf-8")
    for name in ("reconstruct", "Campaign", "calibrate", "import_results", "shape_classes"):
        assert f'id="{name.lower()}"' in api, name


def test_formulas_are_drawn_by_a_mathjax_of_the_site(copy, tmp_path):
    done = make(copy, tmp_path / "site")
    assert done.returncode == 0, done.stderr
    html = tmp_path / "site" / "html"
    page = (html / "theory" / "mass-properties.html").read_text(encoding="utf-8")
    assert page.count('class="arithmatex"') > 10
    assert "$$" not in page
    scripts = re.findall(r'<script src="([^"]*mathjax/[^"]*)"', page)
    assert len(scripts) == 2
    for file in (*scripts, "../mathjax/config/TeX-AMS_SVG.js", "../mathjax/jax/output/SVG/fonts/TeX"):
        assert (html / "theory" / file).exists(), file


@pytest.mark.parametrize(
    ("link", "message"),
    [("[a](none.md)", "no such file"),
     ("[a](theory.md#nowhere)", "theory.html#nowhere: no such anchor"),
     ("[a](#nowhere)", "#nowhere: no such anchor")],
    ids=["file", "anchor", "anchor_of_the_page"],
)  # fmt: skip
def test_a_broken_link_is_an_error(copy, tmp_path, link, message):
    with open(copy / "docs" / "parameters.md", "a", encoding="utf-8") as page:
        page.write(f"\n{link}\n")
    done = make(copy, tmp_path / "site")
    assert done.returncode != 0
    assert message in done.stderr


def commands():
    """(page, words) of every command `clast` in the pages."""
    found = []
    for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").rglob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        for block in re.findall(r"```sh\n(.*?)```", text, re.S):
            for line in block.replace("\\\n", " ").splitlines():
                if not re.search(r"\bclast ", line):
                    continue
                lexer = shlex.shlex(line, posix=True, punctuation_chars=";|&()")
                lexer.whitespace_split = True
                words = []
                for word in [*lexer, ";"]:
                    if not re.fullmatch(r"[;|&()]+", word):
                        words.append(word)
                        continue
                    if words and words[0] == "clast" and "..." not in words:
                        found.append((page.name, words[1:]))
                    words = []
    return found


def help_texts(program, words=()):
    """The help text of a command and of those below it, by their names: "clast-library-set"."""
    text = subprocess.run([program, "help", *words], check=True, capture_output=True, text=True).stdout
    found = {"-".join(["clast", *words]): text}
    for part in re.findall(r"^  ([a-z]+) ", text.partition("\nSubcommands:")[2].split("\n\n")[0], re.M):
        found |= help_texts(program, (*words, part))
    return found


def test_commands_of_the_pages_have_options_that_there_are():
    program = os.environ.get("CLAST_PROGRAM")
    if not program:
        pytest.skip("CLAST_PROGRAM names no program")
    pages = help_texts(program)
    found = commands()
    assert len(found) >= 30
    for page, words in found:
        options = {word.split("=")[0] for word in words if re.fullmatch(r"--?[a-z][a-z-]*(=.*)?", word)}
        if not words or words[0].startswith("-"):
            assert options <= {"--version", "--help"}, (page, words)
            continue
        names = [f"clast-{'-'.join(words[:n])}" for n in (2, 1) if len(words) >= n]
        manual = next((pages[name] for name in names if name in pages), None)
        if words[0] == "help":
            continue
        assert manual, f"{page}: there is no command clast {words[0]}"
        for option in options:
            assert re.search(rf"(?<![\w-]){option}(?![\w-])", manual), f"{page}: clast {words}: {option}"
