"""Figures a tooth: IoU and Dice by face area, distance between the borders in mm. Everything that the study says of
accuracy comes from here; matching and areas are those of bench/score.py."""
import os
import sys

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import score  # noqa: E402


class Truth:
    """A mesh with its exact labels, and of each tooth the points of its border, made once."""

    def __init__(self, v, f, reference):
        self.v, self.f, self.reference = v, f, reference
        self.area = score.areas(v, f)
        e = np.sort(np.vstack([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]]), axis=1)
        order = np.lexsort((e[:, 1], e[:, 0]))
        e, face = e[order], np.tile(np.arange(len(f)), 3)[order]
        pair = np.flatnonzero((e[1:] == e[:-1]).all(1))
        self.edge, self.left, self.right = e[pair], face[pair], face[pair + 1]

    def border(self, mask):
        """Three points on each edge between the faces in `mask` and the others."""
        edge = self.edge[mask[self.left] != mask[self.right]]
        a, b = self.v[edge[:, 0]], self.v[edge[:, 1]]
        return np.vstack([a * (1 - t) + b * t for t in (0.25, 0.5, 0.75)])

    def figures(self, predicted, teeth=None):
        """A dict a tooth (of `teeth`, or all): iou, dice, edge and p95, both ways over the border. A tooth under IoU of 0.5 is
        not found: its border is not measured."""
        kept = np.unique(self.reference[self.reference > 0])
        area = self.area
        parts = [p for p in np.unique(predicted) if p]
        teeth_index, part_index = np.searchsorted(kept, self.reference), np.searchsorted(parts, predicted)
        on = (self.reference > 0) & (predicted > 0)
        common = np.bincount(teeth_index[on] * max(1, len(parts)) + part_index[on], area[on],
                             len(kept) * max(1, len(parts))).reshape(len(kept), -1)
        whole_t = np.bincount(teeth_index[self.reference > 0], area[self.reference > 0], len(kept))
        whole_p = np.bincount(part_index[predicted > 0], area[predicted > 0], max(1, len(parts)))
        iou = common / np.maximum(whole_t[:, None] + whole_p[None] - common, 1e-12)
        out, left = {int(t): {"iou": 0.0, "dice": 0.0, "edge": None, "p95": None} for t in kept}, iou.copy()
        while left.size and left.max() > 0:
            i, j = np.unravel_index(left.argmax(), left.shape)
            left[i, :], left[:, j] = 0, 0
            r = out[int(kept[i])]
            r["iou"], r["dice"] = float(iou[i, j]), float(2 * common[i, j] / (whole_t[i] + whole_p[j]))
            if iou[i, j] >= 0.5 and (teeth is None or int(kept[i]) in teeth):
                a, b = self.border(self.reference == kept[i]), self.border(predicted == parts[j])
                d = np.concatenate([cKDTree(b).query(a)[0], cKDTree(a).query(b)[0]]) if len(a) and len(b) else None
                if d is not None:
                    r["edge"], r["p95"] = float(d.mean()), float(np.percentile(d, 95))
        return {t: r for t, r in out.items() if teeth is None or t in teeth}


def summary(teeth):
    """Figures of many teeth as one row. The border: mean over teeth found, and the largest and the 95th percentile of the
    teeth's means."""
    iou = np.array([r["iou"] for r in teeth])
    edge = np.array([r["edge"] for r in teeth if r["edge"] is not None])
    p95 = np.array([r["p95"] for r in teeth if r["p95"] is not None])
    nan = float("nan")
    return {"teeth": len(teeth), "iou": float(iou.mean()), "least": float(iou.min()), "iou_p5": float(np.percentile(iou, 5)),
            "dice": float(np.mean([r["dice"] for r in teeth])), "lost": int((iou < 0.5).sum()),
            "edge": float(edge.mean()) if len(edge) else nan, "edge_max": float(edge.max()) if len(edge) else nan,
            "edge_p95": float(p95.mean()) if len(p95) else nan}
