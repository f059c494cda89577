#!/usr/bin/env python3
"""Blocks found in virtual deposits: makes deposits, reconstructs them, scores them, and prints a table.

    deposit_benchmark.py BUILD_DIR OUT_DIR [--kinds heap,slope] [--seeds 1001-1010] [--option "--noise 0.4"]

BUILD_DIR is a build of clast, such as build/release. What exists in OUT_DIR is not made again, so that an
interrupted run continues. The table has a row for each deposit and one for all of them.
"""
import argparse
import csv
import json
import math
import statistics
import subprocess
import time
from pathlib import Path

QUANTITIES = ["L_m", "I_m", "S_m", "volume_m3"]


def run(command, output):
    """Runs a command whose standard output becomes a file, unless the file exists."""
    if output.exists():
        return
    partial = output.with_name(output.name + ".part")
    with open(partial, "w", encoding="utf-8") as file:
        subprocess.run([str(word) for word in command], stdout=file, check=True)
    partial.rename(output)


def write_bodies(blocks, path):
    """Writes the sizes, bounds and intervals of clast's blocks as score_deposit reads them."""
    columns = ["block"]
    for name in QUANTITIES:
        columns += [name, name + "_low", name + "_high", name + "_low90", name + "_high90"]
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(columns)
        for block in blocks:
            unseen = block["unseen"]
            row = [block["id"].rsplit("_", 1)[1]]
            for axis in range(3):
                row.append(block["box_m"][axis])
                for key in ["axes_lower_m", "axes_upper_m", "axes_lower90_m", "axes_upper90_m"]:
                    row.append(unseen[key][axis] if unseen[key] else "")
            row.append(block["volume_m3"])
            for key in ["volume_lower_m3", "volume_upper_m3", "volume_lower90_m3", "volume_upper90_m3"]:
                row.append("" if unseen[key] is None else unseen[key])
            table.writerow(row)


def measure(build, folder, kind, seed, options):
    """Makes, reconstructs and scores one deposit."""
    folder.mkdir(parents=True, exist_ok=True)
    scene = folder / "scene"
    if not (scene / "blocks.csv").exists():
        subprocess.run([build / "samples/deposit/make_deposit", scene, "--kind", kind, "--seed",
                        str(seed), *options], check=True, stdout=subprocess.DEVNULL)
    blocks, labelled = folder / "blocks.json", folder / "labelled.ply"
    if not blocks.exists():
        library = folder / "blocks.h5"
        library.unlink(missing_ok=True)
        start = time.time()
        run([build / "app/clast", "reconstruct", scene / "scan.ply", "-o", library, "--split",
             "--labelled", labelled, "--json"], blocks)
        (folder / "seconds.txt").write_text(f"{time.time() - start:.1f}\n", encoding="utf-8")
    write_bodies(json.loads(blocks.read_text(encoding="utf-8"))["blocks"], folder / "bodies.csv")
    run([build / "samples/deposit/score_deposit", scene, labelled, "--bodies", folder / "bodies.csv"],
        folder / "score.json")
    return json.loads((folder / "score.json").read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--kinds", default="heap")
    parser.add_argument("--seeds", default="1001-1010", help="first-last")
    parser.add_argument("--option", default="", help="further options of make_deposit")
    args = parser.parse_args()
    first, last = (int(seed) for seed in args.seeds.split("-"))
    names = ["eligible", "precision", "recall", "close_fraction"]
    print(f"{'deposit':16}" + "".join(f"{name:>15}" for name in names))
    scores = []
    for kind in args.kinds.split(","):
        for seed in range(first, last + 1):
            score = measure(args.build, args.out / f"{kind}_{seed}", kind, seed, args.option.split())
            scores.append(score)
            print(f"{kind + ' ' + str(seed):16}" + "".join(f"{score[name]:15.3f}" for name in names),
                  flush=True)
    eligible = sum(score["eligible"] for score in scores)
    matched = sum(score["matched"] for score in scores)
    close = sum(score["close"] for score in scores)
    false = sum(score["false_proposals"] for score in scores)
    print(f"{'all':16}{eligible:15d}{matched / (matched + false):15.3f}{matched / eligible:15.3f}"
          f"{close / matched:15.3f}")
    print("\nmedians over the deposits")
    for name in QUANTITIES:
        rows = [score["bodies"][name] for score in scores if name in score.get("bodies", {})]
        line = f"{name:10}"
        for key in ["median_absolute_error", "bias"]:
            line += f" {key} {statistics.median(row[key] for row in rows):7.3f}"
        for key in ["bounds", "intervals"]:
            held = [row[key]["coverage"] * row[key]["count"] for row in rows if row.get(key)]
            count = [row[key]["count"] for row in rows if row.get(key)]
            if count and not math.isnan(sum(held)):
                line += f" {key} hold {sum(held) / sum(count):.3f}"
        print(line)


if __name__ == "__main__":
    main()
