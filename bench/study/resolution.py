"""Section 2 (paper, Figs. 7 and 8): coarser meshes of an arch, and noise on it, for the default and the paper's preset."""
import meshes
import plots
from clicking import Arch
from crowding import CROWDING, SEEDS, models, rows_of
from pieces import Piece
from scoring import summary
from targets import Figure
from text import number, table

FACES = (302118, 50000, 10000)
NOISE = (0.05, 0.2, 0.5)  # standard deviation a coordinate, mean edge lengths
PRESETS = ("default", "paper")
MOST = 0.03  # of IoU that may be lost


def arches(study):
    return {case: models(study)[case] for case in ("A" if study.quick else "AG")}


def faces_of(study, spec):
    """The whole arch first, as None."""
    return [None] + [n for n in (FACES[2:] if study.quick else FACES[1:]) if n < spec["triangles"]]


def noises(study):
    return NOISE[::2] if study.quick else NOISE


def mesh_of(study, spec, faces, noise):
    return meshes.decimated(study, spec, faces) if faces else meshes.arch(study, **spec, noise=noise)


def measure(study, spec, faces, noise, seeds):
    arch = Arch(study, mesh_of(study, spec, faces, noise))
    return {**arch.size(), "presets": {preset: {"seeds": arch.clicked(seeds, preset=preset)} for preset in PRESETS}}


def picture(study, spec, faces, noise, name):
    """Paper's figure: a row an arch, a column a level; the default's teeth by the clicks of the first seed."""
    import draw
    levels = [(n, 0) for n in faces] or [(None, x) for x in noise]
    figure, axes = draw.plt.subplots(1, len(levels), figsize=(3.4 * len(levels), 3), squeeze=False)
    for ax, (n, x) in zip(axes[0], levels):
        arch = Arch(study, mesh_of(study, spec, n, x))
        segmentation = arch.scan.prepare("default")
        segmentation.click_all(arch.clicks("pairs", SEEDS[0])[0])
        draw.show(ax, arch.v, arch.f, labels=segmentation.labels(), pixels=480)
        ax.set_title("noise %g" % x if x else "%d faces" % len(arch.f), fontsize=9)
    figure.tight_layout()
    draw.save(figure, plots.drawn(study, name))
    return {}


def levels_of(study, spec):
    """(kind, level as the table has it, name of the piece's end, faces, noise)"""
    return ([("faces", n or spec["triangles"], n, 0) for n in faces_of(study, spec)] +
            [("noise", x, None, x) for x in noises(study)])


def name_of(case, kind, level):
    return "%s/%s-%g" % ({"faces": "resolution", "noise": "noise"}[kind], case, level)


def pieces(study):
    seeds, out = list(SEEDS[:1] if study.quick else SEEDS), []
    for case, spec in arches(study).items():
        for kind, level, faces, noise in levels_of(study, spec):
            out.append(Piece(name_of(case, kind, level), "resolution", "measure",
                             {"spec": spec, "faces": faces, "noise": noise, "seeds": seeds}, tools=("make-arch", "ts-decimate")))
        if study.pictures:
            for kind, faces, noise in (("resolution", faces_of(study, spec), []), ("noise", [], list(noises(study)))):
                out.append(Piece("picture/%s-%s" % (kind, case), "resolution", "picture", {
                    "spec": spec, "faces": faces, "noise": noise, "name": "%s-%s" % (kind, case)}, tools=("make-arch", "ts-decimate")))
    return out


def figures(study, results):
    """(case, kind, preset) -> [(level, result, summary)], the first level being what the others are held against."""
    out = {}
    for case, spec in arches(study).items():
        for kind, level, _, _ in levels_of(study, spec):
            r = results.get(name_of(case, kind, level), {"error": "not measured"})
            for preset in PRESETS if "error" not in r else ():
                out.setdefault((case, kind, preset), []).append((level, r, summary(rows_of(r["presets"][preset]))))
    return out


def losses(study, results):
    """What the default loses of IoU from the first level to the last: {(kind, case): loss}, where both were measured."""
    out = {}
    for (case, kind, preset), got in figures(study, results).items():
        whole = [level for k, level, _, _ in levels_of(study, arches(study)[case]) if k == kind]
        if preset == "default" and [got[0][0], got[-1][0]] == [whole[0], whole[-1]]:
            out[kind, case] = got[0][2]["iou"] - got[-1][2]["iou"]
    return out


def headline(study, results):
    last = {"faces": "%d faces" % FACES[-1], "noise": "noise %g" % NOISE[-1]}
    return [Figure("IoU lost at %s, %s" % (last[kind], case), loss, "<= .03", MOST, "less", 0.01)
            for (kind, case), loss in losses(study, results).items()]


def section(study, results):
    rows, got = [], figures(study, results)
    for kind in ("faces", "noise"):
        for (case, k, preset), levels in got.items():
            if k != kind:
                continue
            for level, r, s in levels:
                refused = sum(len(x["failed"]) for x in r["presets"][preset]["seeds"].values())
                rows.append([case, r["triangles"], "%g" % level if kind == "noise" else "0", preset, r["teeth"], r["groups"], refused,
                             number(s["iou"], 4), number(s["least"]), number(s["dice"], 4), number(s["edge"]), number(s["edge_p95"]),
                             number(levels[0][2]["iou"] - s["iou"], 4)])
    head = ["model", "faces", "noise", "preset", "teeth", "groups", "refused", "IoU", "least", "Dice", "edge", "p95", "IoU lost"]
    text = ["## 2. Resolution and noise (Figs. 7, 8)", "",
            "%s of section 1, decimated (OpenMesh's quadrics; a coarser mesh is scored against its own labels), and with Gaussian noise on "
            "every coordinate, its standard deviation in mean edge lengths. Clicks as there, seeds %s. `IoU lost`: against the row "
            "of the same model, preset and kind with the most faces or the least noise. The paper's preset is the paper to the letter: a "
            "tooth and its neighbour alone, and the cut by gradient." % (
                " and ".join("%s (%s, %s)" % (c, spec["jaw"], CROWDING[c]) for c, spec in arches(study).items()),
                ", ".join(map(str, SEEDS[:1] if study.quick else SEEDS))), "", table(head, rows), ""]
    missing = [name for case, spec in arches(study).items() for kind, level, _, _ in levels_of(study, spec)
               for name in [name_of(case, kind, level)] if "error" in results.get(name, {"error": ""})]
    text += ["Failed: " + ", ".join(missing) + ".", ""] if missing else []
    if study.pictures and got:
        panels = []
        for kind, title, label in (("faces", "Resolution", "faces"), ("noise", "Noise", "standard deviation, mean edge lengths")):
            panels.append((title, label, kind == "faces", {
                "%s, %s" % (case, preset): ([level for level, _, _ in levels], [s["iou"] for _, _, s in levels])
                for (case, k, preset), levels in got.items() if k == kind}))
        plots.lines(study, "resolution-noise", panels)
        text += plots.placed(study, "resolution-noise", "IoU over faces and over noise")
        for case in arches(study):
            text += plots.placed(study, "resolution-" + case, "Model %s at each resolution" % case)
            text += plots.placed(study, "noise-" + case, "Model %s with each noise" % case)
    return text
