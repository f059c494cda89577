#!/usr/bin/env python3
"""Draws sentences of messages, help texts, report texts and documents, for a reader to judge.

    tests/sentence_sample.py PROGRAM SEED [COUNT]

prints COUNT (60) numbered sentences: a quarter each from the messages of the libraries, the help
texts of PROGRAM, the texts of report/, and the pages of docs/ and README.md. A reader who does not
know the sources marks those that are clear at first reading.
"""
import random
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def literals(folders):
    """String literals that read as sentences, adjacent ones joined, with "..." for values."""
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*.cpp")):
            text = re.sub(r"^\s*(//|#include).*$", "", path.read_text(encoding="utf-8"), flags=re.M)
            text = re.sub(r'"\s*\n\s*"', "", text)
            text = re.sub(r'" \+\s*[^";{}]{1,60}?\+\s*"', "...", text)
            for match in LITERAL.finditer(text):
                sentence = match[1].replace("\\n", " ").replace('\\"', '"').strip()
                sentence = re.sub(r"^[ :;,.]+", "", sentence)
                if len(re.findall(r"[a-z]{2,}", sentence)) >= 6 and not re.search("[<=]", sentence):
                    yield sentence


def help_texts(program):
    """Texts of the help: of each command, option and argument, and the paragraphs below."""
    commands = re.findall(r"^  (\w[\w ]*?)  ", run(program, "help"), flags=re.M)
    for command in commands:
        text = run(program, "help", *command.split())
        text = re.sub(r"^(Usage|Examples?):.*?(?=^\S|\Z)|^[A-Z][\w ]*:$", "", text, flags=re.S | re.M)
        entry = ""
        for line in [*text.splitlines(), ""]:
            name = re.match(r"  (\S.*?)(?:\s{2,}(\S.*))?$", line)
            if name and len(line) - len(line.lstrip()) == 2:
                yield from help_entry(entry)
                entry = re.search(r"--[\w-]+|\w+", name[1])[0] + ": " + (name[2] or "")
            elif entry and line.startswith(" " * 20):
                entry += " " + line.strip()
            else:
                yield from help_entry(entry)
                entry = ""
                yield from sentences(line)


def help_entry(entry):
    text = re.sub(r"(Needs|Excludes): \S+ ?|REQUIRED ?", "", entry).strip()
    if len(re.findall(r"[A-Za-z]{2,}", text)) >= 5:
        yield text


def documents():
    """Sentences of the pages, without code, tables and formulas."""
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        text = re.sub(r"```.*?```|\$\$.*?\$\$|<!--.*?-->|^[|#].*?$", "\n\n", text, flags=re.S | re.M)
        for paragraph in re.split(r"\n\s*\n|\n\s*(?:[-*]|\d+\.) ", text):
            yield from sentences(paragraph)


def sentences(paragraph):
    for sentence in re.split(r"(?<=[.!:])\s+(?=[A-Z`])", " ".join(paragraph.split())):
        if len(re.findall(r"[A-Za-z]{2,}", sentence)) >= 5:
            yield sentence


def run(program, *words):
    return subprocess.run([program, *words], capture_output=True, text=True, check=True).stdout


def main():
    program, seed = sys.argv[1], int(sys.argv[2])
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 60
    draw = random.Random(seed)
    libraries = ["app", "core", "mesh", "shapes", "massprops", "classify", "library", "pipeline",
                 "reconstruct", "terrain", "dem", "study"]
    drawn = []
    for source in (literals(libraries), help_texts(program), literals(["report"]), documents()):
        drawn += draw.sample(sorted(set(source)), count // 4)
    draw.shuffle(drawn)
    for number, sentence in enumerate(drawn, 1):
        print(f"{number}. {sentence}")


if __name__ == "__main__":
    main()
