#!/usr/bin/env python3
"""Checks that source files compile alone, with warnings as errors.

The release build compiles about 20 files of a library as one, so a file can use an include of
another by mistake. This script runs the compiler with -fsyntax-only. It needs a build in
build/release, for the generated files.

    tests/build/compile_alone.py             the .cpp files that the last 40 commits changed; of
                                             more than 200 an even sample, which takes 10 minutes
    tests/build/compile_alone.py FILE ...    these
    tests/build/compile_alone.py --all       every .cpp file
"""
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILT = ROOT / "build/release"
ALONE = ROOT / "build/alone"
COMMITS = "-40"
MOST_CHANGED = 200


def configure():
    """Writes the compile commands of a build that compiles each file alone."""
    done = subprocess.run(
        ["cmake", "-S", ROOT, "-B", ALONE, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DCLAST_TESTS=ON", "-DCLAST_COMPILE_TOGETHER=OFF", "-DCLAST_WERROR=ON",
         "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "--log-level=WARNING"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stdout)


def chosen(arguments):
    """Paths of the files to check; none stands for all."""
    if arguments == ["--all"]:
        return None
    if arguments:
        return {Path(argument).resolve() for argument in arguments}
    log = subprocess.run(["git", "log", COMMITS, "--name-only", "--format="], cwd=ROOT,
                         stdout=subprocess.PIPE, text=True, check=False)
    if log.returncode != 0:
        sys.exit("error: the changed files are known in a git clone only; name files, or give --all")
    return {ROOT / line for line in log.stdout.splitlines() if line}


def syntax_command(command):
    """The compile command, without its output and with the generated files of build/release."""
    command = re.sub(r" -o \S+( -c)?", " -fsyntax-only", command)
    return shlex.split(command.replace(str(ALONE), str(BUILT)))


def check(entry):
    """What the compiler says about a file, empty where it is sound."""
    done = subprocess.run(syntax_command(entry["command"]), cwd=BUILT, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    return done.stdout if done.returncode != 0 else ""


def main(arguments):
    wanted = chosen(arguments)
    configure()
    entries = {}
    for entry in json.loads((ALONE / "compile_commands.json").read_text()):
        file = Path(entry["file"])
        if BUILT not in file.parents and ALONE not in file.parents:
            if wanted is None or file in wanted:
                entries[file] = entry
    if not arguments and len(entries) > MOST_CHANGED:
        step = -(-len(entries) // MOST_CHANGED)
        print(f"{len(entries)} files changed: one of {step} is checked, --all checks every file")
        entries = dict(sorted(entries.items())[::step])
    if arguments and wanted:
        for file in sorted(wanted - entries.keys()):
            sys.exit(f"error: {file} is not compiled by this build")
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        for file, said in zip(entries, pool.map(check, entries.values())):
            if said:
                failed += 1
                print(f"error: {file.relative_to(ROOT)} does not compile alone:\n{said}", flush=True)
    print(f"{len(entries)} files compiled alone, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
