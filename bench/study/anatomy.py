"""Section 8: how a click on a molar comes to its cuts, as the paper's Figs. 2 to 4 show it."""
import numpy as np
from scipy.spatial import cKDTree

import fields
import meshes
import plots
from clicking import Arch
from crowding import models
from pieces import Piece
from text import number, table

CASE, TOOTH = "A", 36  # a first molar, on an arch of the mildest crowding
WAYS = {"paper, one point": ("paper", 1), "paper, all points": ("paper", 0), "default": ("default", 0)}  # points a tooth, 0 all
SEAM = 2.4  # mm around a place of the gum line that is shown
BAND = (0.5, 1.2)  # mm on both sides of the gum line, within which the field is compared
GREY = (0.35, 0.35, 0.35)
CHOSEN = {1: "blue", 2: "red"}  # the target's contour and the neighbour's, as the field has them


class Molar:
    """A click on the tooth, and the views that its pictures have in common."""

    def __init__(self, study, spec, way):
        self.arch = Arch(study, meshes.arch(study, **spec))
        at, self.view, self.around = fields.beside(self.arch, TOOTH)
        self.segmentation = self.arch.scan.prepare(WAYS[way][0], points_per_group=WAYS[way][1])
        self.click = self.segmentation.click(at)
        self.info = self.segmentation.info(self.click)
        self.field = self.segmentation.field(self.click)

    def seam(self):
        """The place of the tooth's gum line that is furthest out, seen from there."""
        eye, up = np.asarray(self.view[0]), np.asarray(self.view[1])
        out = eye - (eye @ up) * up
        border = self.arch.truth.border(self.arch.reference == TOOTH)
        return {"view": (out + 0.5 * up, up), "around": (border[(border @ out).argmax()], SEAM)}

    def step(self):
        """How much the field rises over the gum line: mean on the gingiva less mean on the tooth, both within BAND of the line."""
        arch, (v, _) = self.arch, self.mesh()
        away = cKDTree(arch.truth.border(arch.reference == TOOTH)).query(v)[0]
        band = np.flatnonzero((away > BAND[0]) & (away < BAND[1]))
        on = arch.reference[cKDTree(arch.v[arch.f].mean(1)).query(v[band])[1]]
        return float(self.field[band[on == 0]].mean() - self.field[band[on == TOOTH]].mean())

    def constraints(self):
        """Feature points that are held, on the tooth clicked (blue, 0) and on the others (red, 1)."""
        seeds = {t: set(self.segmentation.seeds(t)) for t in self.segmentation.teeth()}
        held = [(p, p.group == self.info.target) for p in self.arch.scan.points() if p.vertex in seeds.get(p.group, ())]
        return [([tuple(p.position)], "blue" if own else "red", 6) for p, own in held]

    def lines(self):
        """Every contour, and the two chosen ones over them."""
        told = self.segmentation.contours_of(self.click)
        order = sorted(range(len(told)), key=lambda i: told[i].chosen)
        return [(line, CHOSEN.get(told[i].chosen, GREY), 2.0 if told[i].chosen else 0.45)
                for i in order for line in self.segmentation.contour_lines(self.click, i)]

    def mesh(self):
        return self.arch.scan.positions(), self.arch.scan.triangles()


def measure(study, spec, way):
    """What the click's histogram and contours say in numbers, and how good the molar is that they give."""
    m = Molar(study, spec, way)
    bins, contours = m.segmentation.histogram(m.click), m.segmentation.contours_of(m.click)
    most = int(bins.argmax())
    chosen = {str(c.chosen): {"iso": c.iso, "gradient": c.gradient, "concavity": c.concavity} for c in contours if c.chosen}
    return {**meshes.size_of(m.arch.mesh), "v_med": m.info.v_med, "bin_max": [most / len(bins), (most + 1) / len(bins)], "contours": len(contours),
            "in_bin_max": float(bins[most] / bins.sum()), "target_iso": m.info.target_iso, "neighbour_iso": m.info.neighbour_iso, "chosen": chosen,
            "step": m.step(),
            "tooth": m.arch.truth.figures(m.segmentation.labels(), [TOOTH])[TOOTH]}


def picture_constraints(study, spec, name):
    """Figs. 2 and 3: a row for one pair of constraints, one for all, and one for the default."""
    import draw
    figure, axes = draw.plt.subplots(len(WAYS), 3, figsize=(9, 3.1 * len(WAYS)), constrained_layout=True)
    for row, way in zip(axes, WAYS):
        m = Molar(study, spec, way)
        v, f = m.mesh()
        whole = {"view": m.view, "around": m.around}
        draw.show(row[0], v, f, vertex_scalar=m.field, points=m.constraints(), **whole)
        draw.show(row[1], v, f, vertex_scalar=m.field, lines=m.lines(), **m.seam())
        draw.show(row[2], m.arch.v, m.arch.f, labels=m.segmentation.labels(), **whole)
        for ax, text in zip(row, ("A: field, " + way, "B: the seam at the gum", "C: result")):
            ax.set_title(text, fontsize=9)
    draw.save(figure, plots.drawn(study, name))
    return {}


def picture_cuts(study, spec, name):
    """Fig. 4, with all points: a row a preset."""
    import draw
    ways = [w for w in WAYS if WAYS[w][1] == 0]
    figure, axes = draw.plt.subplots(len(ways), 3, figsize=(10.4, 3.1 * len(ways)), constrained_layout=True,
                                     gridspec_kw={"width_ratios": (1, 1, 1.25)})
    for row, way in zip(axes, ways):
        m = Molar(study, spec, way)
        v, f = m.mesh()
        draw.show(row[0], v, f, lines=m.lines(), view=m.view, around=m.around)
        draw.show(row[1], v, f, lines=m.lines(), **m.seam())
        histogram(row[2], m)
        for ax, text in zip(row, ("A: all contours, " + way, "B: contours at the seam", "C: vertices over the field")):
            ax.set_title(text, fontsize=9)
    draw.save(figure, plots.drawn(study, name))
    return {}


def histogram(ax, m):
    import draw
    bins = m.segmentation.histogram(m.click)
    edges = np.linspace(0, 1, len(bins) + 1)
    ax.bar(edges[:-1], bins, np.diff(edges), align="edge", color=draw.FIELD((edges[:-1] + edges[1:]) / 2), edgecolor=GREY, linewidth=0.3)
    most = bins.argmax()
    ax.plot((edges[most] + edges[most + 1]) / 2, bins[most], "o", markersize=9, markerfacecolor="none", color="black", label="Bin_max")
    ax.axvline(m.info.v_med, color="black", linestyle="--", linewidth=1, label="V_med %.2f" % m.info.v_med)
    for which, iso, colour in (("target", m.info.target_iso, "blue"), ("neighbour", m.info.neighbour_iso, "red")):
        ax.axvline(iso, color=colour, linewidth=1.2, label="cut of the %s %.2f" % (which, iso))
    ax.set(yscale="log", xlim=(0, 1), ylim=(0.7, 60 * bins.max()), xlabel="field", ylabel="vertices")
    ax.legend(fontsize=7, loc="upper center", ncols=2)


def pieces(study):
    spec = models(study)[CASE]
    out = [Piece("anatomy/" + way.replace(", ", "-").replace(" ", "-"), "anatomy", "measure", {"spec": spec, "way": way}, tools=("make-arch",))
           for way in WAYS]
    if study.pictures:
        out += [Piece("picture/molar-" + what, "anatomy", "picture_" + what, {"spec": spec, "name": "molar-" + what}, tools=("make-arch",))
                for what in ("constraints", "cuts")]
    return out


def section(study, results):
    rows = []
    for piece in (p for p in pieces(study) if p.function == "measure"):
        way, r = piece.arguments["way"], results.get(piece.name, {"error": "not measured"})
        if "error" in r:
            rows.append([way, "failed: " + r["error"]] + [""] * 12)
            continue
        rows.append([way, r["triangles"], r["contours"], number(r["v_med"]), "%.2f to %.2f" % tuple(r["bin_max"]), number(r["in_bin_max"])])
        for which, iso in (("1", r["target_iso"]), ("2", r["neighbour_iso"])):
            c = r["chosen"].get(which)
            rows[-1] += [number(iso, 2), number(c["gradient"]) if c else "-", number(c["concavity"]) if c else "-"]
        rows[-1] += [number(r["step"]), number(r["tooth"]["iou"], 4)]
    head = ["way", "triangles", "contours", "V_med", "Bin_max", "its share", "target's cut", "gradient", "concavity", "neighbour's cut",
            "gradient", "concavity", "step", "IoU"]
    text = ["## 8. Anatomy of a click (Figs. 2 to 4)", "",
            "One click on the first molar %d of model %s, on the untouched scan. The field is 0 (blue) on the tooth clicked and 1 (red) on its "
            "neighbour; the default preset also holds all other teeth and the gingiva at 1/2. `gradient`: mean along the chosen contour, 1/mm; "
            "`concavity`: its share in concave valleys. `step`: how much the field rises from the tooth to the gingiva, %g to %g mm from the gum "
            "line: what the paper wants more constraints for. `IoU`: of the molar. Balls: the constraints; "
            "thick lines: the chosen contours, before the default moves them into the valleys." % (TOOTH, CASE, *BAND), "", table(head, rows), ""]
    if study.pictures:
        text += plots.placed(study, "molar-constraints", "The paper's preset with one pair of constraints and with all: field, seam, result")
        text += plots.placed(study, "molar-cuts", "Contours, those at the seam, and the histogram with Bin_max, V_med and the cuts")
    return text
