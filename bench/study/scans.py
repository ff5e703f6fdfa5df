"""Section 7: labelled real scans where they are present. Numbers only: neither a scan nor a picture of one is in the project."""
import argparse
import json
import os
import subprocess
import tempfile

import accuracy
import meshes
from pieces import Piece
from targets import Figure
from text import number, table

# What makes a scan hard, as the README beside the scans says it.
KINDS = {"ml-ex01-upper": "raw", "gse-case-lower": "model with base", "als-001-upper": "trimmed", "als-013-upper": "gaps",
         "als-014-upper": "gaps", "als-021-upper": "gaps", "als-024-upper": "gaps", "ios-027-lower": "gaps", "ios-061-lower": "raw",
         "ios-065-lower": "raw", "triar-kec-upper": "raw", "triar-kec-lower": "raw", "triar-ae-upper": "raw",
         "triar-ae-lower": "raw", "t3ds-01dke9wr-lower": "brackets", "t3ds-ybsesun6-upper": "model with base",
         "plaster-g8906-lower": "crowded", "plaster-g4555-upper": "model with base"}
SEEDS = (1, 2, 3)  # of the clicks in pairs
MODES = {"auto": (1,), "pairs": SEEDS}


def measure(study, scan, files):
    """Runs of both modes as bench/accuracy.py has them. Without labels: how many clicks the tool gives, and how many teeth it
    separates."""
    tool = meshes.tool(study, "ts-segment")
    if "face_labels.txt" not in files:
        with tempfile.TemporaryDirectory() as folder:
            report = os.path.join(folder, "report.json")
            done = subprocess.run([tool, os.path.join(study.scans, scan, "mesh.ply"), "--auto", "--report", report, "--threads", "1"],
                                  capture_output=True, text=True)
            if not os.path.exists(report):
                raise RuntimeError(done.stderr.strip())
            with open(report) as file:
                return {"counts": json.load(file)["counts"]}
    options = argparse.Namespace(scans=study.scans, scorer=study.scorer, tool=tool)
    out = {mode: [accuracy.run(options, scan, "default", mode, seed) for seed in seeds] for mode, seeds in MODES.items()}
    for run in (r for runs in out.values() for r in runs):
        if "error" in run:
            raise RuntimeError(run["error"])
    return out


def pieces(study):
    if study.quick or not os.path.isdir(study.scans) or not os.path.exists(study.scorer):
        return []
    judge = [meshes.digest(study.scorer), meshes.digest(accuracy.__file__)]
    out = []
    for scan in sorted(os.listdir(study.scans)):
        folder = os.path.join(study.scans, scan)
        files = {n: meshes.digest(os.path.join(folder, n)) for n in ("mesh.ply", "face_labels.txt") if os.path.exists(os.path.join(folder, n))}
        if "mesh.ply" in files:
            out.append(Piece("scans/" + scan, "scans", "measure", {"scan": scan, "files": files | dict(zip(("scorer", "accuracy"), judge))},
                             tools=("ts-segment",)))
    return out


def labelled(study, results):
    """{scan: result} of those that were measured against labels."""
    got = {p.arguments["scan"]: results.get(p.name, {}) for p in pieces(study)}
    return {scan: r for scan, r in got.items() if "pairs" in r}


def headline(study, results):
    got = labelled(study, results)
    rows = {mode: accuracy.row([x for r in got.values() for x in r[mode]]) for mode in MODES} if got else {}
    return [f for mode, r in rows.items() for f in (
        Figure("mean IoU, " + mode, r["iou"], "", None, "more", 0.005),
        Figure("teeth under .5, " + mode, r["under50"], "", None, "less", 0))]


def figures(runs):
    """Cells of a table. Clicks are those of one seed (of all its scans), refused ones those of all seeds."""
    r, seeds = accuracy.row(runs), len({x["seed"] for x in runs})
    return [r["clicks"] // seeds, r["failed"], number(r["iou"], 4), number(r["min"]), number(r["dice"], 4), number(r["edge"])]


def section(study, results):
    text, mine = ["## 7. Labelled real scans", ""], pieces(study)
    if not mine:
        return text + ["Not measured: " + ("the quick form leaves them out." if study.quick else "there are no scans where --scans says."), ""]
    rows, got = [], labelled(study, results)
    for piece in mine:
        scan, r = piece.arguments["scan"], results.get(piece.name, {"error": "not measured"})
        start = [scan, KINDS.get(scan, "-")]
        if "error" in r:
            rows.append(start + ["failed: " + r["error"]] + [""] * 12)
        elif scan in got:
            rows.append(start + [r["auto"][0]["teeth"]] + figures(r["auto"]) + figures(r["pairs"]))
        else:
            rows.append(start + ["%d given, no labels" % r["counts"]["teeth"], r["counts"]["clicks"], r["counts"]["failed_clicks"]] + ["-"] * 10)
    groups = {}
    for scan, r in got.items():
        groups.setdefault(KINDS.get(scan, "-"), []).append(r)
    groups["**all**"] = list(got.values())
    totals = [[kind, len(some), sum(r["auto"][0]["teeth"] for r in some)] + figures([x for r in some for x in r["auto"]]) +
              figures([x for r in some for x in r["pairs"]]) for kind, some in groups.items() if some]
    columns = [mode + " " + c for mode in MODES for c in ("clicks", "refused", "IoU", "least", "Dice", "edge")]
    return text + [
        "Full arches of real people, 10,000 to 106,000 triangles, labels from their sources; they are no part of the project. `auto`: "
        "ts-segment clicks for itself; `pairs`: a click for every two teeth on the half of a crown that faces the next, seeds %s. "
        "`clicks`: clicks given, none by hand after them; `refused`: those that gave an error, of all seeds. Boundary error (`edge`) in "
        "mm over the matched teeth." % ", ".join(map(str, SEEDS)), "", table(["scan", "kind", "teeth"] + columns, rows), "",
        "By kind, over teeth:", "", table(["kind", "scans", "teeth"] + columns, totals), ""]
