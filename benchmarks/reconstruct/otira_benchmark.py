#!/usr/bin/env python3
"""Grains of a natural gravel bed, outlined by hand, that a segmentation finds.

    otira_benchmark.py LABELLED.ply

LABELLED.ply holds points of $CLAST_DATA/deposit/otira_1cm.ply, in any order, with the integer property `block`
(0: none), as `clast reconstruct --split --labelled` writes it; missing points have none. A grain is the set of points
inside its outline in plan. Printed as JSON are the best intersection over union (IoU) of each grain with a block, the
numbers of grains with an IoU above 0.7 and 0.5, and the number and the smallest widths in plan of the blocks that
have 50 points or more. The numbers are repeated for the points seen from above, as the outlines were drawn: points
that have another one 0.1 m above them, within 1.5 cm in plan, lie under an overhang and are left out.
"""
import argparse
import csv
import json
import math
import os
import struct
from collections import Counter, defaultdict
from itertools import product
from pathlib import Path

OUTLINES = Path(__file__).resolve().parents[2] / "samples/deposit/otira_outlines.csv"
CODES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
         "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
         "double": "d", "float64": "d"}
SMALLEST_BLOCK = 50  # points
DIRECTIONS = 90  # in which the width of a block is measured
COVER_RADIUS, COVER_HEIGHT = 0.015, 0.1  # of a point that hides another one from above, m


def read_vertices(path, names):
    """Reads the named properties of the vertices of a binary little-endian PLY file."""
    with open(path, "rb") as file:
        count, properties, form, inside = 0, [], "", False
        while (line := file.readline()).strip() != b"end_header":
            if not line:
                raise SystemExit(f"{path}: the header of a PLY file has no end")
            words = line.decode("ascii", "replace").split()
            if words[:1] == ["format"]:
                form = words[1]
            elif words[:1] == ["element"]:
                inside = words[1] == "vertex"
                count = int(words[2]) if inside else count
            elif words[:1] == ["property"] and inside:
                properties.append((words[2], CODES.get(words[1])))
        if form != "binary_little_endian":
            raise SystemExit(f"{path}: format {form or 'not stated'}; needs binary_little_endian")
        missing = [name for name in names if (name not in dict(properties))]
        if missing or None in dict(properties).values():
            raise SystemExit(f"{path}: vertices need properties {', '.join(names)} and no lists")
        row = struct.Struct("<" + "".join(code for _, code in properties))
        data = file.read(row.size * count)
        if len(data) < row.size * count:
            raise SystemExit(f"{path}: {len(data) // row.size} of {count} vertices")
    order = [[name for name, _ in properties].index(name) for name in names]
    return [tuple(values[i] for i in order) for values in row.iter_unpack(data)]


def read_outlines(path):
    """Reads the vertices of each outline, in m."""
    outlines = defaultdict(list)
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            outlines[int(row["grain"])].append((float(row["x_m"]), float(row["y_m"])))
    return dict(outlines)


def find_labels(points, labelled):
    """Finds the label of each point by its coordinates, to 0.1 mm; 0 where the labelled cloud lacks it."""
    cells = defaultdict(list)
    for x, y, z, block in labelled:
        cells[tuple(math.floor(c * 1e3) for c in (x, y, z))].append((x, y, z, block))
    labels = []
    for point in points:
        cell = [math.floor(c * 1e3) for c in point]
        label = 0
        for step in product((0, -1, 1), repeat=3):
            for other in cells.get(tuple(c + s for c, s in zip(cell, step)), ()):
                if math.dist(point, other[:3]) < 1e-4:
                    label = other[3]
                    break
            else:
                continue
            break
        labels.append(label)
    return labels


def is_inside(x, y, outline):
    """Returns whether a place is inside a polygon."""
    inside = False
    for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


def find_seen(points):
    """Finds the indices of the points that are seen from above."""
    cells = defaultdict(list)
    for x, y, z in points:
        cells[math.floor(x / COVER_RADIUS), math.floor(y / COVER_RADIUS)].append((x, y, z))
    seen = []
    for i, (x, y, z) in enumerate(points):
        cell = math.floor(x / COVER_RADIUS), math.floor(y / COVER_RADIUS)
        if not any(top > z + COVER_HEIGHT and math.hypot(a - x, b - y) <= COVER_RADIUS
                   for i_step, j_step in product((-1, 0, 1), repeat=2)
                   for a, b, top in cells.get((cell[0] + i_step, cell[1] + j_step), ())):
            seen.append(i)
    return seen


def find_best(outline, points, labels, sizes):
    """Finds the block that overlaps an outline most."""
    x_low, x_high = min(x for x, _ in outline), max(x for x, _ in outline)
    y_low, y_high = min(y for _, y in outline), max(y for _, y in outline)
    inside = [label for (x, y, _), label in zip(points, labels)
              if x_low <= x <= x_high and y_low <= y <= y_high and is_inside(x, y, outline)]
    best = {"points": len(inside), "block": 0, "iou": 0.0}
    for block, shared in sorted(Counter(inside).items()):
        iou = shared / (len(inside) + sizes[block] - shared)
        if block > 0 and iou > best["iou"]:
            best.update(block=block, iou=round(iou, 4))
    return best


def score_grains(outlines, points, labels):
    """Scores all outlines on the same points."""
    sizes = Counter(labels)
    grains = [{"grain": grain, **find_best(outline, points, labels, sizes)}
              for grain, outline in sorted(outlines.items())]
    return {"above_0.7": sum(grain["iou"] > 0.7 for grain in grains),
            "above_0.5": sum(grain["iou"] > 0.5 for grain in grains), "grains": grains}


def plan_width(places):
    """Measures the smallest width of a set of places in plan, m."""
    widths = []
    for k in range(DIRECTIONS):
        c, s = math.cos(math.pi * k / DIRECTIONS), math.sin(math.pi * k / DIRECTIONS)
        along = [c * x + s * y for x, y, _ in places]
        widths.append(max(along) - min(along))
    return min(widths)


def quantile(values, p):
    """Interpolates a quantile between the sorted values."""
    place = p * (len(values) - 1)
    low = math.floor(place)
    return values[low] + (place - low) * (values[min(low + 1, len(values) - 1)] - values[low])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("labelled", type=Path)
    args = parser.parse_args()
    if "CLAST_DATA" not in os.environ:
        raise SystemExit("CLAST_DATA is not set; it names the folder that holds deposit/otira_1cm.ply")
    points = read_vertices(Path(os.environ["CLAST_DATA"]) / "deposit/otira_1cm.ply", ["x", "y", "z"])
    labels = find_labels(points, read_vertices(args.labelled, ["x", "y", "z", "block"]))
    sizes, blocks = Counter(labels), defaultdict(list)
    for point, label in zip(points, labels):
        if label > 0 and sizes[label] >= SMALLEST_BLOCK:
            blocks[label].append(point)
    widths = sorted(plan_width(places) for places in blocks.values())
    outlines, seen = read_outlines(OUTLINES), find_seen(points)
    result = {"outlines": len(outlines), "blocks": len(widths)}
    if widths:
        result["plan_width_m"] = {f"D{p}": round(quantile(widths, p / 100), 4) for p in (16, 50, 84)}
    result["all_points"] = score_grains(outlines, points, labels)
    result["seen_from_above"] = score_grains(outlines, [points[i] for i in seen], [labels[i] for i in seen])
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
