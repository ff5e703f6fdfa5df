#!/usr/bin/env python3
"""Scores a label per face against exact labels, by face area: intersection over union and Dice a tooth.

    score.py MESH.ply REFERENCE.txt PREDICTED.txt

For meshes that the project makes itself. Teeth and predicted parts are matched one to one, largest IoU first.
Needs python3-numpy.
"""
import json
import sys

import numpy as np

PLY_TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4",
             "int32": "<i4", "uint": "<u4", "uint32": "<u4", "float": "<f4", "float32": "<f4", "double": "<f8",
             "float64": "<f8"}


def read_ply(path):
    """Positions and triangles of a binary little-endian PLY whose faces are all triangles."""
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    offset, tables = end, {}
    element, fields, count = None, [], 0

    def take():
        nonlocal offset
        if element:
            tables[element] = np.frombuffer(data, np.dtype(fields), count, offset)
            offset += tables[element].nbytes

    for words in (line.split() for line in data[:end].decode().splitlines()):
        if words[0] == "element":
            take()
            element, count, fields = words[1], int(words[2]), []
        elif words[0] == "property" and words[1] == "list":
            fields += [("corners", PLY_TYPES[words[2]]), ("index", PLY_TYPES[words[3]], 3)]
        elif words[0] == "property":
            fields.append((words[2], PLY_TYPES[words[1]]))
    take()
    v = tables["vertex"]
    return np.stack([v["x"], v["y"], v["z"]], 1).astype(float), tables["face"]["index"].astype(np.int64)


def areas(v, f):
    """mm^2 a face."""
    return np.linalg.norm(np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]]), axis=1) / 2


face_areas = areas


def match(area, reference, predicted):
    """For each reference tooth its IoU and Dice."""
    teeth = [t for t in np.unique(reference) if t]
    parts = [p for p in np.unique(predicted) if p]
    whole_t = np.array([area[reference == t].sum() for t in teeth])
    whole_p = np.array([area[predicted == p].sum() for p in parts])
    common = np.array([[area[(reference == t) & (predicted == p)].sum() for p in parts] for t in teeth])
    common = common.reshape(len(teeth), len(parts))
    iou = common / (whole_t[:, None] + whole_p[None] - common)
    got, dice, left = np.zeros(len(teeth)), np.zeros(len(teeth)), iou.copy()
    while left.size and left.max() > 0:
        i, j = np.unravel_index(left.argmax(), left.shape)
        got[i], dice[i] = iou[i, j], 2 * common[i, j] / (whole_t[i] + whole_p[j])
        left[i, :], left[:, j] = 0, 0
    false = int((iou.max(0) < 0.3).sum()) if len(teeth) and len(parts) else len(parts)
    return teeth, got, dice, false


def score(v, f, reference, predicted):
    """The figures of a whole arch; border distances are left to the scorer of the real scans."""
    teeth, iou, dice, false = match(areas(v, f), reference, predicted)
    return {"teeth": len(teeth), "iou_mean": iou.mean(), "iou_min": iou.min(), "dice_mean": dice.mean(),
            "share_090": (iou >= 0.9).mean(), "missed": int((iou < 0.5).sum()), "false": false,
            "edge_mean": float("nan"), "edge_p95": float("nan")}


def along_arch(teeth):
    """FDI numbers from one end of the jaw to the other: the patient's right, then left."""
    right = sorted((t for t in teeth if t // 10 in (1, 4)), reverse=True)
    return right + sorted(t for t in teeth if t // 10 in (2, 3))


def make_clicks(v, f, reference, how, seed):
    """Clicks "x y z tooth": `each` crown once, or `pairs` (N/2: on the half of a crown that faces the next tooth)."""
    rng, area, middle = np.random.default_rng(seed), areas(v, f), v[f].mean(1)
    order = along_arch([t for t in np.unique(reference) if t])
    centre = {t: np.average(middle[reference == t], axis=0, weights=area[reference == t]) for t in order}
    for k in range(0, len(order), 2 if how == "pairs" else 1):
        tooth = order[k]
        on = np.where(reference == tooth)[0]
        # not at the very border of the crown
        reach = np.linalg.norm(middle[on] - centre[tooth], axis=1)
        on = on[reach < np.quantile(reach, 0.8)]
        if how == "pairs":
            other = order[k + 1] if k + 1 < len(order) else order[k - 1]
            side = (middle[on] - centre[tooth]) @ (centre[other] - centre[tooth])
            on = on[side >= np.median(side)]
        print("%.5f %.5f %.5f %d" % (*middle[rng.choice(on, p=area[on] / area[on].sum())], tooth))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    v, f = read_ply(sys.argv[1])
    reference, predicted = (np.loadtxt(name, dtype=int) for name in sys.argv[2:])
    for name, labels in zip(sys.argv[2:], (reference, predicted)):
        if len(labels) != len(f):
            sys.exit("score.py: %s has %d labels, %s has %d faces" % (name, len(labels), sys.argv[1], len(f)))
    teeth, iou, dice, false = match(areas(v, f), reference, predicted)
    print(json.dumps({"teeth": len(teeth), "predicted": len(set(predicted) - {0}), "false": false,
                      "iou_mean": round(float(iou.mean()), 4), "iou_min": round(float(iou.min()), 4),
                      "dice_mean": round(float(dice.mean()), 4),
                      "per_tooth": {int(t): round(float(x), 4) for t, x in zip(teeth, iou)}}))


if __name__ == "__main__":
    main()
