"""Section 5 (paper, Fig. 9): a morphologic skeleton and CGAL's segmentation by shape diameters, beside ours in the same run."""
import json
import os
import subprocess
import time

import numpy as np

import crowding
import meshes
import plots
from clicking import Arch
from library import Library, Scan
from pieces import Piece, library_path
from scoring import summary
from targets import Figure
from text import ms, number, table

METHODS = {"skeleton": "Morphologic skeleton", "sdf": "Shape diameters (CGAL)"}
# The shape diameters take minutes on large meshes: they are given decimated ones, and one whole arch to see what that costs them.
SDF_FACES, SDF_QUICK = 50000, 10000
WHOLE = "A, whole"
FIG_9 = {"B": (42629, 1319), "D": (159208, 3279)}  # the paper's ms a tooth: ref. 28, and its own


def runs(study, method):
    """{name: (specification, faces or None)}"""
    specs = crowding.models(study)
    if method == "skeleton":
        return {case: (spec, None) for case, spec in specs.items()}
    if study.quick:
        return {"A": (specs["A"], SDF_QUICK)}
    return {**{case: (spec, SDF_FACES) for case, spec in specs.items()}, WHOLE: (specs["A"], None)}


def mesh_of(study, spec, faces):
    return meshes.decimated(study, spec, faces) if faces else meshes.arch(study, **spec)


def theirs(study, mesh, teeth, method):
    """The labels a face of the best run, and what ts-rival tells of it."""
    base = os.path.join(study.folder, "rival.%d" % os.getpid())
    subprocess.run([meshes.tool(study, "ts-rival"), mesh.path, "--teeth", str(teeth), "--method", method, "--labels", base + ".txt",
                    "--json", base + ".json"], check=True, capture_output=True)
    with open(base + ".json") as file:
        told = json.load(file)
    labels = np.fromfile(base + ".txt", dtype=np.int64, sep="\n")
    for end in (".txt", ".json"):
        os.remove(base + end)
    return labels, told


def timed(study, mesh, clicks):
    """From the file to the labels: each stage's ms, and the labels."""
    library, at = Library(library_path(study), 1), [time.perf_counter()]
    scan = Scan(library, mesh.path)
    at.append(time.perf_counter())
    segmentation = scan.prepare()
    at.append(time.perf_counter())
    segmentation.click_all(clicks)
    labels = segmentation.labels()
    at.append(time.perf_counter())
    return dict(zip(("scan", "prepare", "clicks"), 1000 * np.diff(at))), labels


def measure(study, spec, faces, method, seeds):
    """Both on one core. Ours once for each seed of the clicks, and the median time."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])
    arch = Arch(study, mesh_of(study, spec, faces))
    size = arch.size()
    labels, told = theirs(study, arch.mesh, size["teeth"], method)
    rest, area = labels == 0, arch.truth.area
    out = {**size, "told": told, "theirs": arch.truth.figures(labels), "helped": arch.truth.figures(helped(arch, labels)),
           "rest": float(area[rest & (arch.reference == 0)].sum() / max(area[rest].sum(), 1e-12)), "ours": [], "ms": []}
    for seed in seeds:
        stages, labels = timed(study, arch.mesh, arch.clicks("pairs", seed)[0])
        out["ms"].append(stages)
        out["ours"] += list(arch.truth.figures(labels).values())
    return out


def helped(arch, labels):
    """Each of its parts given to the tooth, or gingiva, that most of it lies on: what the best joining of parts could come to."""
    part, teeth = np.unique(labels, return_inverse=True)[1], np.unique(arch.reference, return_inverse=True)
    on = np.zeros((part.max() + 1, len(teeth[0])))
    np.add.at(on, (part, teeth[1]), arch.truth.area)
    return teeth[0][on.argmax(1)][part]


def picture(study, cases):
    """Paper's Fig. 9: a row an arch; theirs, and ours."""
    import draw
    figure, axes = draw.plt.subplots(len(cases), 3, figsize=(10.5, 3.1 * len(cases)), squeeze=False, constrained_layout=True)
    for row, (case, spec) in zip(axes, cases.items()):
        for ax, method in zip(row, METHODS):
            faces = (runs(study, method).get(case) or (None, SDF_FACES))[1]
            arch = Arch(study, mesh_of(study, spec, faces))
            draw.show(ax, arch.v, arch.f, labels=theirs(study, arch.mesh, arch.size()["teeth"], method)[0], pixels=500)
            ax.set_title("%s: %s" % (case, METHODS[method]), fontsize=9)
        arch = Arch(study, meshes.arch(study, **spec))
        segmentation = arch.scan.prepare()
        segmentation.click_all(arch.clicks("pairs", crowding.SEEDS[0])[0])
        draw.show(row[2], arch.v, arch.f, labels=segmentation.labels(), pixels=500)
        row[2].set_title("%s: ours" % case, fontsize=9)
    draw.save(figure, plots.drawn(study, "rival"))
    return {}


def pieces(study):
    if not meshes.tool(study, "ts-rival"):
        return []
    seeds, tools = list(crowding.SEEDS[:1] if study.quick else crowding.SEEDS), ("make-arch", "ts-decimate", "ts-rival")
    out = [Piece("rival/%s-%s" % (method, name), "rival", "measure", {"spec": spec, "faces": faces, "method": method, "seeds": seeds},
                 True, tools) for method in METHODS for name, (spec, faces) in runs(study, method).items()]
    if study.pictures:
        cases = {c: spec for c, spec in crowding.models(study).items() if c in ("A" if study.quick else "BD")}
        out.append(Piece("picture/rival", "rival", "picture", {"cases": cases}, tools=tools))
    return out


def ratios(r):
    """Theirs against ours: error (1 - IoU), time of the best run and with its search; and ms, theirs with its search and ours."""
    a, b, told = summary(list(r["theirs"].values())), summary(r["ours"]), r["told"]
    once = told["intake_ms"] + told["time_ms"]
    ours = float(np.median([sum(stages.values()) for stages in r["ms"]]))
    return {"error": (1 - a["iou"]) / (1 - b["iou"]), "once": once / ours, "search": (once + told["search_ms"]) / ours,
            "their_ms": once + told["search_ms"], "our_ms": ours}


def measured(study, results, method):
    got = {name: results.get("rival/%s-%s" % (method, name), {"error": "not measured"}) for name in runs(study, method)}
    return {name: r for name, r in got.items() if "error" not in r}, [name for name, r in got.items() if "error" in r]


def headline(study, results):
    """Guarded as ratios, by half of each: times of a busy machine and errors near 0 vary much."""
    out = []
    for method in METHODS:
        every = [ratios(r) for r in measured(study, results, method)[0].values()]
        for what, text, target in (("error", "error", ("> 1", 1.0)), ("search", "time, search included", (None, None))):
            least = min((r[what] for r in every), default=float("nan"))
            out.append(Figure("%s / ours, least: %s" % (method, text), least, *target, "more", least / 2))
    return out


def row_of(name, r):
    a, b, q, told = summary(list(r["theirs"].values())), summary(r["ours"]), ratios(r), r["told"]
    setting = number(told["threshold"]) if "threshold" in told else "%g, %g" % (told["clusters"], told["lambda"])
    return [name, r["triangles"], told["teeth"], r["teeth"], setting, number(a["iou"]), number(summary(list(r["helped"].values()))["iou"]),
            number(r["rest"], 2), number(b["iou"]), a["lost"], number(a["edge"]), number(b["edge"]), number(q["error"], 1), ms(q["our_ms"]),
            ms(q["their_ms"]), number(q["once"], 2), number(q["search"], 1)]


def section(study, results):
    text = ["## 5. The rivals (Fig. 9)", "",
            "Both are told the number of teeth and are searched for the setting that finds most nearly so many; they need no click. Each "
            "piece ran alone on the machine, theirs and ours in turn on one core. `IoU helped`: theirs with each part given to the tooth that "
            "it mostly lies on, which needs the truth: what the best joining of its parts could come to. `rest`: how much of what it calls "
            "no tooth is none. `error`: (1 - IoU), theirs / ours. `our ms`: from the file to the labels of all clicks, features and "
            "preparation included (median over the seeds of the clicks); `their ms`: from the file, search included. `once`: time of theirs "
            "with its best setting known / ours; `search`: with its search / ours. A tooth counts as lost under IoU .5.", ""]
    head = ["model", "triangles", "found", "teeth", "setting", "IoU", "IoU helped", "rest", "our IoU", "lost", "edge", "our edge", "error",
            "our ms", "their ms", "once", "search"]
    for method, title in METHODS.items():
        got, failed = measured(study, results, method)
        text += ["### " + title, "", ABOUT[method], ""]
        text += [table(head, [row_of(name, r) for name, r in got.items()]), ""] if got else []
        text += ["Not measured: %s (ts-rival has to be built, for shape diameters with CGAL)." % ", ".join(failed), ""] if failed else []
        if method == "skeleton":
            text += against_paper(got)
    return text + plots.placed(study, "rival", "The rivals' best runs, and ours")


ABOUT = {
    "skeleton": "As the literature describes its family (refs. 23, 26, 28): curvature, threshold, closing, thinning, regions; of 20 "
                "thresholds (`setting`, 1/mm) the best; surplus regions are joined for it. `ts-rival --help` tells more.",
    "sdf": "The general-purpose peer: clusters of the shape diameter with a graph cut, then connected parts, the largest taken for "
           "gingiva. `setting`: clusters and lambda, of a grid of 20. On decimated meshes, ours on the same, because of its time; `%s` is "
           "not decimated. Shape diameters are thicknesses, and a crown is no thinner where it touches the next." % WHOLE}


def against_paper(got):
    lines = []
    for case, (their, our) in FIG_9.items():
        if case in got:
            q, teeth = ratios(got[case]), got[case]["teeth"]
            lines.append("%s: the paper %d and %d ms (%.0f times), here %s and %s ms (%.1f times)" % (
                case, their, our, their / our, ms(q["their_ms"] / teeth), ms(q["our_ms"] / teeth), q["search"]))
    return ["A tooth, the skeleton with its search and ours, in Fig. 9 and here: %s. The paper ran the program of ref. 28, which its user "
            "helps; ours of that family is not that program." % "; ".join(lines), ""] if lines else []
