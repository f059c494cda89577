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
    run([build / "app/clast", "classify", folder / "blocks.h5", "--scheme", "sneed-folk", "--json"],
        folder / "population.json")
    return json.loads((folder / "score.json").read_text(encoding="utf-8"))


def quantile(values, fraction):
    """Smallest value up to which there is at least the fraction of the values."""
    return sorted(values)[math.ceil(fraction * len(values)) - 1]


def score_population(folder):
    """Relative errors of D50 and D84 of I of all true bodies, found and corrected, and the true fractions of the
    classes of eligible and of all bodies with their intervals."""
    with open(folder / "scene" / "blocks.csv", newline="", encoding="utf-8") as file:
        truth = list(csv.DictReader(file))
    deposit = json.loads((folder / "population.json").read_text(encoding="utf-8"))["deposit"]
    errors = {}
    for name, fraction in [("D50", 0.5), ("D84", 0.84)]:
        true_size = quantile([float(body["I_m"]) for body in truth], fraction)
        for weighting in ["number", "corrected"]:
            size = deposit["sizes"][weighting]["I_m"][name]
            errors[weighting, name] = size["value"] / true_size - 1
            errors[weighting, name, "held"] = size["low"] <= true_size <= size["high"]
    classes = {"found": [], "corrected": []}
    for key, bodies in [("found", [b for b in truth if b["eligible"] == "1"]), ("corrected", truth)]:
        for one in deposit["classes"]["sneed-folk"]:
            true_fraction = sum(body["class"] == one["class"] for body in bodies) / len(bodies)
            low, high = one[key]["low"], one[key]["high"]
            classes[key].append((low <= true_fraction <= high, high - low, one["class"],
                                 one[key]["value"] - true_fraction))
    return errors, classes


def print_populations(folders):
    """Prints the bars of the population: mean bias of D50 and D84, and coverage of class fractions."""
    scores = [score_population(folder) for folder in folders]
    print("\nI of all true bodies by number: mean relative error over the deposits, and in each of them")
    for name in ["D50", "D84"]:
        for weighting in ["number", "corrected"]:
            errors = [errors[weighting, name] for errors, _ in scores]
            held = sum(errors[weighting, name, "held"] for errors, _ in scores)
            print(f"{name} by {weighting:10}{statistics.mean(errors):8.3f}   interval holds {held}/{len(errors)}   "
                  + " ".join(f"{error:6.3f}" for error in errors))
    print("\nfractions of the Sneed-Folk classes inside their 95 % intervals")
    for key, bodies in [("found", "eligible bodies"), ("corrected", "all bodies")]:
        rows = [row for _, classes in scores for row in classes[key]]
        print(f"{bodies:16}{sum(row[0] for row in rows) / len(rows):7.3f} of {len(rows)}, median width "
              f"{statistics.median(row[1] for row in rows):.3f}, mean width "
              f"{statistics.mean(row[1] for row in rows):.3f}")


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
    scores, folders = [], []
    for kind in args.kinds.split(","):
        for seed in range(first, last + 1):
            folders.append(args.out / f"{kind}_{seed}")
            score = measure(args.build, folders[-1], kind, seed, args.option.split())
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
    print_populations(folders)


if __name__ == "__main__":
    main()
