"""Section 4 (paper, Figs. 2 and 3): a molar held at one feature point, as its neighbour, against both held at all of theirs."""
import fields
import meshes
import plots
from clicking import Arch
from crowding import models
from library import Failure
from pieces import Piece
from scoring import summary
from targets import Figure
from text import number, table

SMALL = 60000
PRESETS = ("default", "paper")
POINTS = {"one": 1, "all": 0}  # points_per_group
REFUSED = {"iou": 0.0, "dice": 0.0, "edge": None, "p95": None}


def arches(study):
    return {case: {**models(study)[case], "triangles": triangles(study)} for case in ("A" if study.quick else "ADFGHI")}


def triangles(study):
    return 20000 if study.quick else SMALL


def molars(reference):
    return [int(t) for t in sorted(set(reference)) if t > 0 and t % 10 in (6, 7, 8)]


def measure(study, spec):
    """A click on each molar, each on an untouched preparation: figures of the molar clicked, None where the click was refused."""
    arch = Arch(study, meshes.arch(study, **spec))
    out = {**arch.size(), "ways": {preset: {points: {} for points in POINTS} for preset in PRESETS}}
    for tooth in molars(arch.reference):
        at = arch.top_of(tooth)
        for preset in PRESETS:
            for points, most in POINTS.items():
                segmentation = arch.scan.prepare(preset, points_per_group=most)
                try:
                    segmentation.click(at)
                    got = arch.truth.figures(segmentation.labels(), [tooth])[tooth]
                except Failure:
                    got = None
                out["ways"][preset][points][str(tooth)] = got
    return out


def picture(study, spec, tooth, name):
    arch = Arch(study, meshes.arch(study, **spec))
    fields.compare(study, name, arch, tooth, [("%s, %s" % (preset, "one point" if points == "one" else "all points"), preset,
                                               {"points_per_group": POINTS[points]}) for preset in PRESETS[::-1] for points in POINTS])
    return {}


def pieces(study):
    out = [Piece("constraints/" + case, "constraints", "measure", {"spec": spec}, tools=("make-arch",))
           for case, spec in arches(study).items()]
    if study.pictures:
        out.append(Piece("picture/constraints", "constraints", "picture", {"spec": arches(study)["A"], "tooth": 36, "name": "constraints"},
                         tools=("make-arch",)))
    return out


def headline(study, results):
    """Guarded only: what the default makes of molars at all their points."""
    got = [results.get("constraints/" + case, {}) for case in arches(study)]
    teeth = [x for r in got if "ways" in r for x in r["ways"]["default"]["all"].values()]
    return [Figure("IoU of molars, all points", summary([x or REFUSED for x in teeth])["iou"], None, None, "more", 0.01)] if teeth else []


def section(study, results):
    rows, every = [], {}
    for case in arches(study):
        r = results.get("constraints/" + case, {"error": "not measured"})
        if "error" in r:
            rows.append([case, "failed: " + r["error"]] + [""] * 7)
            continue
        for preset in PRESETS:
            for points in POINTS:
                every.setdefault((preset, points), []).extend(r["ways"][preset][points].values())
                rows.append([case, preset, points, *row_of(r["ways"][preset][points].values())])
    rows += [["all", preset, points, *row_of(teeth)] for (preset, points), teeth in every.items()]
    head = ["model", "preset", "points", "molars", "refused", "not found", "IoU", "edge", "p95"]
    return ["## 4. Single against multiple constraints (Figs. 2, 3)", "",
            "A click on each molar of arches of section 1 with %d triangles, each on the untouched scan; figures are of the molar clicked. "
            "`one`: a tooth is held at one feature point (points_per_group = 1), `all`: at all of its points; the default "
            "makes a disc of each. A click that was refused counts as IoU 0." % triangles(study), "", table(head, rows), "",
            *plots.placed(study, "constraints", "Field, contours and result with one point a tooth and with all")]


def row_of(teeth):
    teeth = list(teeth)
    s = summary([x or REFUSED for x in teeth])
    return [len(teeth), sum(x is None for x in teeth), s["lost"], number(s["iou"], 4), number(s["edge"]), number(s["edge_p95"])]
