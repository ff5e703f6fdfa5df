"""Section 5 (paper, Fig. 9): the morphologic skeleton on the arches of section 1, its threshold searched for it."""
import json
import os
import subprocess

import numpy as np

import crowding
import meshes
from pieces import Piece
from scoring import Truth, summary
from text import ms, number, table


def measure(study, spec):
    """The best run of the skeleton, and a click for every two teeth of ours, one thread each."""
    mesh = meshes.arch(study, **spec)
    v, f, reference = meshes.read(mesh)
    base = os.path.join(study.folder, "rival.%d" % os.getpid())
    teeth = len(set(reference[reference > 0]))
    subprocess.run([meshes.tool(study, "ts-rival"), mesh.path, "--teeth", str(teeth), "--labels", base + ".txt", "--json",
                    base + ".json"], check=True, capture_output=True)
    with open(base + ".json") as file:
        told = json.load(file)
    predicted = np.fromfile(base + ".txt", dtype=np.int64, sep="\n")
    for end in (".txt", ".json"):
        os.remove(base + end)
    return {"teeth": Truth(v, f, reference).figures(predicted), "time_ms": told["time_ms"], "search_ms": told["search_ms"],
            "found": told["teeth"], "threshold": told["threshold"]}


def pieces(study):
    if not meshes.tool(study, "ts-rival"):
        return []
    return [Piece("rival/" + case, "rival", "measure", {"spec": spec}, tools=("ts-rival",))
            for case, spec in crowding.models(study).items()]


def section(study, results):
    text = ["## 5. The rival (Fig. 9)", ""]
    rows = []
    for case in crowding.models(study):
        theirs, ours = results.get("rival/" + case), results.get("crowding/" + case)
        if not theirs or "error" in theirs or not ours or "error" in ours:
            continue
        a, b = summary(list(theirs["teeth"].values())), summary(crowding.rows_of(ours))
        rows.append([case, theirs["found"], number(theirs["threshold"]), number(a["iou"]), number(b["iou"]), a["lost"], b["lost"],
                     number((1 - a["iou"]) / (1 - b["iou"]), 1), number(a["edge"]), number(b["edge"]), ms(theirs["time_ms"]),
                     ms(theirs["search_ms"])])
    if not rows:
        return text + ["Not measured: ts-rival is not built.", ""]
    head = ["model", "its teeth", "its threshold, 1/mm", "its IoU", "our IoU", "its teeth lost", "ours", "its error / ours (1 - IoU)",
            "its edge", "our edge", "its best run, ms", "its search, ms"]
    return text + [
        "A morphologic skeleton as the literature describes it (curvature, threshold, closing, thinning, regions; `ts-rival --help`), of "
        "20 thresholds the one that finds most nearly the number of teeth, which it is told; surplus regions are joined for it. Its times "
        "are of runs beside another program, and no comparison of speed.", "", table(head, rows), ""]
