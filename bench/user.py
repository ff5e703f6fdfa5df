#!/usr/bin/env python3
"""A simulated user on the labelled scans: N/2 clicks, then corrections of the worst tooth until every tooth is good enough.

    user.py [--library build/release/src/api/libtoothseg.so] [--scans ../shared/data/scans] [--only SUBSTRING] [--most 40]

It sees the reference labels, as a person sees the crowns. After the clicks, one for every two teeth, it takes the tooth with
the least IoU that is under the target (.95 on scans with a mean edge under .5 mm, .90 on others; ts_get_labels against the
reference), finds the largest connected piece that is missing from it or too much, and draws the reference border beside it, a point a
millimetre (ts_cut_draw: one interaction); where that is refused or no help it clicks the middle of the piece: "this too"
(ts_tooth_include) or "not this" (ts_tooth_exclude). A correction after which the tooth is no better is taken back
(ts_undo) and the next largest piece tried; each try counts as an interaction, refused ones too. A crown that has no tooth is
clicked. It gives up on a tooth after ten tries without gain.
"""
import argparse
import json
import os
import sys

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
sys.path[:0] = [HERE, os.path.join(HERE, "study")]
import meshes  # noqa: E402
import score  # noqa: E402
from library import Failure, Library, Scan  # noqa: E402
from text import table  # noqa: E402


class Arch:
    """A labelled scan: areas, what lies beside what, IoU of each tooth."""

    def __init__(self, v, f, reference):
        self.v, self.f, self.reference = v, f, reference
        self.area, self.middle = score.areas(v, f), v[f].mean(1)
        edges = np.sort(np.vstack([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]]), axis=1)
        order = np.lexsort((edges[:, 1], edges[:, 0]))
        edges, face = edges[order], np.tile(np.arange(len(f)), 3)[order]
        pair = np.flatnonzero((edges[1:] == edges[:-1]).all(1))
        a, b = face[pair], face[pair + 1]
        d = np.linalg.norm(self.middle[a] - self.middle[b], axis=1) + 1e-9
        self.beside = coo_matrix((np.r_[d, d], (np.r_[a, b], np.r_[b, a])), shape=(len(f), len(f))).tocsr()
        self.pairs = edges[pair], a, b  # edges, and the two faces of each
        self.edge = float(np.linalg.norm(v[edges[:, 0]] - v[edges[:, 1]], axis=1).mean())
        self.teeth = [int(t) for t in np.unique(reference) if t > 0]

    def matched(self, labels):
        """For each reference tooth its label, and IoU: largest first, one to one."""
        found = [int(x) for x in np.unique(labels) if x > 0]
        iou = np.zeros((len(self.teeth), max(1, len(found))))
        for i, t in enumerate(self.teeth):
            own = self.reference == t
            for j, x in enumerate(found):
                common = self.area[own & (labels == x)].sum()
                if common:
                    iou[i, j] = common / self.area[own | (labels == x)].sum()
        out = {t: (None, 0.0) for t in self.teeth}
        left = iou.copy()
        while found and left.max() > 0:
            i, j = np.unravel_index(left.argmax(), left.shape)
            out[self.teeth[i]] = (found[j], float(iou[i, j]))
            left[i], left[:, j] = 0, 0
        return out

    def border_beside(self, own, piece):
        """The border of the faces `own` as far as it runs along the faces `piece`: its longest line, a point a millimetre."""
        edge, a, b = self.pairs
        line = edge[(own[a] != own[b]) & (piece[a] | piece[b])]
        if len(line) < 2:
            return None
        names, ends = np.unique(line, return_inverse=True)
        ends = ends.reshape(-1, 2)
        d = np.linalg.norm(self.v[line[:, 0]] - self.v[line[:, 1]], axis=1)
        graph = coo_matrix((np.r_[d, d], (np.r_[ends[:, 0], ends[:, 1]], np.r_[ends[:, 1], ends[:, 0]])), shape=(len(names),) * 2).tocsr()
        first = int(np.where(np.isinf(far := dijkstra(graph, indices=0)), -1, far).argmax())
        far, before = dijkstra(graph, indices=first, return_predecessors=True)
        at = int(np.where(np.isinf(far), -1, far).argmax())
        way = [at]
        while before[way[-1]] >= 0:
            way.append(int(before[way[-1]]))
        points = self.v[names[way]]
        along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
        if along[-1] < 1:
            return None
        return points[[int(np.abs(along - t).argmin()) for t in np.linspace(0, along[-1], int(along[-1]) + 2)]]

    def pieces(self, mask):
        """Connected pieces of a set of faces, largest first: area, the place deepest inside, and the faces."""
        faces = np.flatnonzero(mask)
        if not len(faces):
            return []
        graph = self.beside[faces][:, faces]
        count, piece = connected_components(graph, directed=False)
        inner = np.asarray(self.beside[faces][:, ~mask].sum(1)).ravel() > 0  # faces beside others
        out = []
        for k in range(count):
            own = np.flatnonzero(piece == k)
            rim = own[inner[own]]
            depth = dijkstra(graph, indices=rim, min_only=True)[own] if len(rim) else np.zeros(len(own))
            out.append((float(self.area[faces[own]].sum()), self.middle[faces[own[depth.argmax()]]], faces[own]))
        return sorted(out, key=lambda p: -p[0])


def correct(arch, seg, label, tooth, tried):
    """The next thing a person would do about a tooth, or None: what, and where."""
    labels = seg.labels()
    own = arch.reference == tooth
    if label is None:
        options = [("click", *p) for p in arch.pieces(own)]
    else:
        options = [("include", *p) for p in arch.pieces(own & (labels != label))]
        options += [("exclude", *p) for p in arch.pieces(~own & (labels == label))]
    for what, _, at, faces in sorted(options, key=lambda o: -o[1]):
        if what != "click" and not any(w == "draw" and np.linalg.norm(at - q) < 0.5 for w, q, _ in tried):
            piece = np.zeros(len(own), bool)
            piece[faces] = True
            stroke = arch.border_beside(own, piece)
            if stroke is not None:
                return "draw", at, stroke
        if not any(w == what and np.linalg.norm(at - q) < 0.5 for w, q, _ in tried):
            return what, at, None
    return None


def work_on(arch, seg, target, most):
    """Interactions of each kind, teeth given up."""
    count = {"include": 0, "exclude": 0, "draw": 0, "click": 0, "refused": 0, "in vain": 0}
    tried, given_up = {t: [] for t in arch.teeth}, set()
    for _ in range(most):
        now = arch.matched(seg.labels())
        bad = sorted((t for t in arch.teeth if now[t][1] < target and t not in given_up), key=lambda t: now[t][1])
        if not bad:
            break
        tooth = bad[0]
        label, before = now[tooth]
        step = correct(arch, seg, label, tooth, tried[tooth])
        if step is None or len(tried[tooth]) >= 10:
            given_up.add(tooth)
            continue
        what, at, stroke = step
        count[what] += 1
        tried[tooth].append(step)
        try:
            if what == "click":
                seg.click(at)
            elif what == "draw":
                seg.draw(seg.tooth_of_label(label), stroke)
            else:
                seg.correct(what, seg.tooth_of_label(label), at)
        except Failure:
            count["refused"] += 1
            continue
        after = arch.matched(seg.labels())
        if after[tooth][1] <= before or sum(i for _, i in after.values()) < sum(i for _, i in now.values()):
            seg.undo()
            count["in vain"] += 1
        else:
            tried[tooth] = []
    return count, given_up


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library", default=os.path.join(ROOT, "build", "release", "src", "api", "libtoothseg.so"))
    parser.add_argument("--scans", default=os.path.join(ROOT, "..", "shared", "data", "scans"))
    parser.add_argument("--only", default="")
    parser.add_argument("--most", type=int, default=40)
    parser.add_argument("--json")
    options = parser.parse_args()
    library = Library(options.library, os.cpu_count())
    rows, everything = [], []
    for name in sorted(os.listdir(options.scans)):
        folder = os.path.join(options.scans, name)
        if options.only not in name or not os.path.exists(os.path.join(folder, "face_labels.txt")):
            continue
        v, f, reference = meshes.read(meshes.Mesh(os.path.join(folder, "mesh.ply"), os.path.join(folder, "face_labels.txt")))
        arch = Arch(v, f, reference)
        target = 0.95 if arch.edge < 0.5 else 0.90
        seg = Scan(library, os.path.join(folder, "mesh.ply")).prepare()
        clicks = seg.proposed()
        seg.click_all(clicks)
        first = [i for _, i in arch.matched(seg.labels()).values()]
        count, given_up = work_on(arch, seg, target, options.most)
        last = [i for _, i in arch.matched(seg.labels()).values()]
        total = len(clicks) + sum(count[what] for what in ("include", "exclude", "draw", "click"))
        everything.append((len(arch.teeth), total, min(last) >= target))
        rows.append([name, len(arch.teeth), "%.2f" % arch.edge, "%.2f" % target, len(clicks), count["click"], count["include"],
                     count["exclude"], count["draw"], count["refused"], count["in vain"], total, "%.3f" % min(first), "%.3f" % min(last),
                     "%.4f" % np.mean(first), "%.4f" % np.mean(last), len(given_up)])
        print("%-22s %d interactions, least %.3f -> %.3f" % (name, total, min(first), min(last)), file=sys.stderr, flush=True)
    head = ["scan", "teeth", "edge", "target", "clicks", "more clicks", "this too", "not this", "drawn", "refused", "in vain", "interactions",
            "least before", "least after", "mean before", "mean after", "given up"]
    print(table(head, rows))
    if everything:
        spare = np.mean([total - n / 2 for n, total, _ in everything])
        print("\n%d of %d scans with every tooth on target; interactions: N/2 + %.2f in the mean." % (
            sum(good for *_, good in everything), len(everything), spare))
    if options.json:
        with open(options.json, "w") as out:
            json.dump({"head": head, "rows": rows}, out, indent=1)


if __name__ == "__main__":
    main()
