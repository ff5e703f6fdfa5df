"""Section 1 (paper, Fig. 6 and Table 1): ten crowded arches, a click for every two teeth."""
import os

import numpy as np

import meshes
import plots
from clicking import Arch
from pieces import Piece
from scoring import summary
from targets import Figure
from text import number, table

# Jaws, and triangles of the paper's Table 1. The paper's pictures show three degrees of crowding without naming each
# model's; they are spread here so that both jaws have all three. E and F lack a tooth: their last pair is one tooth.
TABLE_1 = [("A", "lower", 302118), ("B", "upper", 226843), ("C", "upper", 903240), ("D", "lower", 452460),
           ("E", "lower", 798524), ("F", "upper", 1022952), ("G", "upper", 302118), ("H", "lower", 1075146),
           ("I", "upper", 1145170), ("J", "lower", 669852)]
PAPER_VERTICES = {"A": 151022, "B": 113489, "C": 451622, "D": 226232, "E": 399264, "F": 511478, "G": 151057, "H": 537571,
                  "I": 572587, "J": 334925}
CROWDING = {"A": "mild", "B": "mild", "C": "moderate", "D": "moderate", "E": "severe", "F": "moderate", "G": "mild",
            "H": "severe", "I": "severe", "J": "mild"}
MISSING = {"E": "46", "F": "24"}
SEEDS = (1, 2, 3)  # of the clicks
STEPS = ("H", "F")  # shown click by click: the most crowded of each jaw that the quick form has too


def models(study):
    """Specifications by letter. Quick: three of them at 60,000 triangles."""
    out = {}
    for place, (case, jaw, triangles) in enumerate(TABLE_1, 1):
        if not study.quick or case in "AFH":
            out[case] = {"jaw": jaw, "crowding": CROWDING[case], "triangles": 60000 if study.quick else triangles,
                         "seed": place, "missing": MISSING.get(case, "")}
    return out


def kept(study, case):
    """Where `measure` keeps the clicks of the first seed, and the labels after each."""
    return os.path.join(study.folder, "crowding-%s.npz" % case)


def measure(study, spec, seeds, case):
    """Figures a tooth for the clicks of each seed."""
    arch = Arch(study, meshes.arch(study, **spec))
    return {**arch.size(), "seeds": arch.clicked(seeds, keep=kept(study, case))}


def picture_steps(study, spec, case):
    """Paper's Fig. 6: consecutive clicks on one arch."""
    import draw
    v, f, _ = meshes.read(meshes.arch(study, **spec))
    shown = np.load(kept(study, case))
    clicks, labels = shown["clicks"], shown["labels"]
    figure, axes = draw.plt.subplots(1, 4, figsize=(13.6, 3.1), constrained_layout=True)
    for k, ax in enumerate(axes):
        n = 1 + round(k * (len(clicks) - 1) / (len(axes) - 1))
        draw.show(ax, v, f, labels=labels[n - 1], points=[(clicks[:n], "black", 3)], pixels=600)
        ax.set_title("%d click%s" % (n, "s" if n > 1 else ""), fontsize=10)
    draw.save(figure, plots.drawn(study, "crowding-" + case))
    return {}


def picture_all(study, specs):
    """What the clicks of the first seed give, of every arch."""
    import draw
    columns = min(5, len(specs))
    rows = -(-len(specs) // columns)
    figure, axes = draw.plt.subplots(rows, columns, squeeze=False, constrained_layout=True, figsize=(2.8 * columns, 2.7 * rows))
    for ax, (case, spec) in zip(axes.flat, specs.items()):
        v, f, _ = meshes.read(meshes.arch(study, **spec))
        draw.show(ax, v, f, labels=np.load(kept(study, case))["labels"][-1], pixels=500)
        ax.set_title("%s: %s, %s" % (case, spec["jaw"], spec["crowding"]), fontsize=9)
    draw.save(figure, plots.drawn(study, "crowding"))
    return {}


def pieces(study):
    """The pictures are drawn from what the measuring pieces keep, and come after them (study.py)."""
    seeds, specs = list(SEEDS[:1] if study.quick else SEEDS), models(study)
    out = [Piece("crowding/" + case, "crowding", "measure", {"spec": spec, "seeds": seeds, "case": case}) for case, spec in specs.items()]
    if study.pictures:
        out += [Piece("picture/crowding-" + case, "crowding", "picture_steps", {"spec": specs[case], "case": case}) for case in STEPS]
        out.append(Piece("picture/crowding", "crowding", "picture_all", {"specs": specs}))
    return out


def rows_of(result):
    """All teeth of all seeds: a tooth counts once a seed."""
    return [r for s in result["seeds"].values() for r in s["teeth"].values()]


def headline(study, results):
    got = [summary(rows_of(r)) for r in (results.get("crowding/" + case, {}) for case in models(study)) if "seeds" in r]
    if not got:
        return []
    return [Figure("mean IoU of the worst arch", min(s["iou"] for s in got), ">= .93", 0.93, "more", 0.02),
            Figure("least tooth of all arches", min(s["least"] for s in got), ">= .75", 0.75, "more", 0.05),
            Figure("mean border error of the worst arch, mm", max(s["edge"] for s in got), "", None, "less", 0.03)]


def section(study, results):
    rows, everyone, misses = [], [], []
    for case, spec in models(study).items():
        r = results.get("crowding/" + case, {"error": "not measured"})
        if "error" in r:
            rows.append([case, spec["jaw"], spec["crowding"], "failed: " + r["error"]] + [""] * 12)
            continue
        s = summary(rows_of(r))
        everyone += rows_of(r)
        first = next(iter(r["seeds"].values()))
        rows.append([case, spec["jaw"], spec["crowding"], r["vertices"], PAPER_VERTICES[case], r["triangles"], r["teeth"], r["groups"],
                     first["clicks"], sum(len(x["failed"]) for x in r["seeds"].values()), number(s["iou"], 4),
                     number(s["least"]), number(s["dice"], 4), number(s["edge"]), number(s["edge_p95"]), number(s["edge_max"])])
        misses += [(case, t, seed, x["iou"]) for seed, c in r["seeds"].items() for t, x in c["teeth"].items() if x["iou"] < 0.75]
    head = ["model", "jaw", "crowding", "vertices", "paper's", "triangles", "teeth", "groups", "clicks", "refused", "IoU", "least", "Dice",
            "edge", "p95", "worst tooth"]
    text = ["## 1. Crowding (Fig. 6, Table 1)", "",
            "An arch a column of the paper's Table 1, with the triangles it names; one click for every two teeth, anywhere on the "
            "half of a crown that faces the next. Seeds of the clicks: %s. `refused`: clicks of all seeds that gave an error. `edge`: mean "
            "distance between the borders, both ways, mm, over teeth; `p95`: mean over teeth of each one's 95th percentile; `worst tooth`: the "
            "largest mean of a tooth. Teeth under IoU .5 count as not found, and have no border." %
            ", ".join(map(str, SEEDS[:1] if study.quick else SEEDS)), "", table(head, rows), ""]
    if everyone:
        s = summary(everyone)
        text += ["All: IoU %s, least %s, fifth percentile %s, Dice %s, edge %s mm (p95 %s), not found %d of %d." % (
            number(s["iou"], 4), number(s["least"]), number(s["iou_p5"]), number(s["dice"], 4), number(s["edge"]), number(s["edge_p95"]),
            s["lost"], s["teeth"]), ""]
    if misses:
        text += ["Teeth under .75 (model, FDI, seeds of the clicks, IoU):", ""]
        by_tooth = {}
        for case, t, seed, x in misses:
            by_tooth.setdefault((case, t), []).append((seed, x))
        text += ["- %s %s: %s" % (case, t, ", ".join("%s (seed %s)" % (number(x), seed) for seed, x in got))
                 for (case, t), got in by_tooth.items()]
        text += [""]
    else:
        text += ["No tooth is under .75." if everyone else "Not measured.", ""]
    if study.pictures:
        for case in STEPS:
            text += plots.placed(study, "crowding-" + case, "Model %s, click by click" % case)
        text += plots.placed(study, "crowding", "All models, separated by the clicks of the first seed")
    return text
