#!/usr/bin/env python3
"""The robustness table: what the pose, the handedness, the order and the noise of a scan change in its result.

    robustness.py [--tool build/release/samples/ts-segment] [--scans ../shared/data/scans] [--scorer ../shared/tools/score_labels.py]
                  [--variants turned1,turned2,turned3,turned1-64,mirrored,inside-out,shuffled,noise0.05,noise0.2,noise0.5]
                  [--only SUBSTRING] [--json OUT] [--markdown OUT] [--jobs 2]

Each labelled scan is run as it is and in variants, with clicks of the tool's own and the default preset:
  turnedN     a random rotation about its centre and a translation of up to 200 mm an axis, coordinates stored as
              float32, as scanners write them
  turnedN-64  the same motion, coordinates stored as float64
  mirrored    x -> -x, the winding of the faces reversed so that they look outwards still
  inside-out  the winding reversed only
  shuffled    vertices and faces in random order, the first corner of each face random
  noiseX      isotropic Gaussian noise with a standard deviation of X mean edges along each axis
All but the noise leave the scan what it was, so its result should stay: "changed" is the share of the area whose label
is another one than on the scan as it is. Labels are matched one to one, since the arch may be walked from either end.
Targets: at most 0.1 % changed and as many groups, on every scan. For the noise the mean IoU over the teeth against the
reference, and what it loses against the scan as it is; target: 0.5 mean edges lose at most 0.02 where the mean edge is
below 0.5 mm (on a coarser scan half an edge is as much as a groove is deep).
Needs python3-numpy and python3-scipy, and the scans, which are not part of the project.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

from accuracy import ROOT, load_scorer

VARIANTS = "turned1,turned2,turned3,turned1-64,mirrored,inside-out,shuffled,noise0.05,noise0.2,noise0.5"
MAX_CHANGED, MAX_LOSS, FINE = 0.001, 0.02, 0.5


def write_ply(path, v, f, kind):
    with open(path, "wb") as out:
        out.write(("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty %s x\nproperty %s y\nproperty %s z\n"
                   "element face %d\nproperty list uchar int vertex_indices\nend_header\n" %
                   (len(v), kind, kind, kind, len(f))).encode())
        out.write(v.astype("<f4" if kind == "float" else "<f8").tobytes())
        rows = np.empty(len(f), np.dtype([("k", "u1"), ("i", "<i4", 3)]))
        rows["k"], rows["i"] = 3, f
        out.write(rows.tobytes())


def rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[:, [1, 0, 2]]


def mean_edge(v, f):
    e = np.unique(np.sort(np.vstack([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]]), axis=1), axis=0)
    return float(np.linalg.norm(v[e[:, 0]] - v[e[:, 1]], axis=1).mean())


def vary(variant, v, f):
    """Vertices, faces, type of the coordinates, and for each face of the variant that of the scan."""
    kind, source = "float", np.arange(len(f))
    if variant.startswith("turned"):
        name, _, bits = variant[len("turned"):].partition("-")
        rng, kind = np.random.default_rng(int(name)), "double" if bits == "64" else "float"
        v = (v - v.mean(0)) @ rotation(rng).T + v.mean(0) + rng.uniform(-200, 200, 3)
    elif variant == "mirrored":
        v, f = v * [-1, 1, 1], f[:, ::-1]
    elif variant == "inside-out":
        f = f[:, ::-1]
    elif variant == "shuffled":
        rng = np.random.default_rng(1)
        order, source = rng.permutation(len(v)), rng.permutation(len(f))
        place = np.empty(len(v), int)
        place[order] = np.arange(len(v))
        corner = (np.arange(3) + rng.integers(0, 3, len(f))[:, None]) % 3
        v, f = v[order], np.take_along_axis(place[f[source]], corner, axis=1)
    elif variant.startswith("noise"):
        v = v + np.random.default_rng(1).normal(size=v.shape) * float(variant[len("noise"):]) * mean_edge(v, f)
    elif variant != "as it is":
        sys.exit("robustness.py: no variant " + variant)
    return v, f, kind, source


def segment(tool, v, f, kind, source):
    """Labels in the order of the scan's faces, and the number of groups; a string if there is no result."""
    with tempfile.TemporaryDirectory() as tmp:
        write_ply(tmp + "/mesh.ply", v, f, kind)
        done = subprocess.run([tool, tmp + "/mesh.ply", "--labels", tmp + "/labels.txt", "--features", tmp + "/features.json",
                               "--threads", "1"], capture_output=True, text=True)
        if not os.path.exists(tmp + "/labels.txt"):
            return "exit %d: %s" % (done.returncode, done.stderr.strip())
        labels = np.empty(len(f), int)
        labels[source] = np.loadtxt(tmp + "/labels.txt", dtype=int)
        return labels, len(json.load(open(tmp + "/features.json"))["groups"])


def changed(area, before, after):
    """Share of the area whose label is another one, after the matching of the labels that leaves least."""
    from scipy.optimize import linear_sum_assignment
    common = np.zeros((before.max() + 1, after.max() + 1))
    np.add.at(common, (before, after), area)
    same = common[1:, 1:]
    return max(0.0, float(1 - (common[0, 0] + same[linear_sum_assignment(-same)].sum()) / common.sum()))


def run(options, scan):
    scorer = load_scorer(options.scorer)
    folder = os.path.join(options.scans, scan)
    v, f = scorer.read_ply(folder + "/mesh.ply")
    ref = np.loadtxt(folder + "/face_labels.txt", dtype=int)
    area = scorer.face_areas(v, f)
    out = {"scan": scan, "mean_edge": mean_edge(v, f), "teeth": len(np.unique(ref[ref > 0])), "variants": {}}
    base = segment(options.tool, *vary("as it is", v, f))
    if isinstance(base, str):
        return {**out, "error": base}
    out["groups"], out["iou"] = base[1], scorer.score(v, f, ref, base[0])["iou_mean"]
    for variant in options.variants:
        got = segment(options.tool, *vary(variant, v, f))
        if isinstance(got, str):
            out["variants"][variant] = {"error": got}
        elif variant.startswith("noise"):
            iou = scorer.score(v, f, ref, got[0])["iou_mean"]
            out["variants"][variant] = {"groups": got[1], "iou": iou, "loss": out["iou"] - iou}
        else:
            out["variants"][variant] = {"groups": got[1], "changed": changed(area, base[0], got[0])}
    return out


def missed(r, variant):
    """True if the variant misses its target; None if it has none."""
    x = r["variants"][variant]
    if "error" in x:
        return True
    if "changed" in x:
        return x["changed"] > MAX_CHANGED or x["groups"] != r["groups"]
    if variant == "noise0.5" and r["mean_edge"] < FINE:
        return x["loss"] > MAX_LOSS
    return None


def cell(r, variant):
    x = r["variants"][variant]
    if "error" in x:
        return "**failed**"
    text = "%.2f %%" % (100 * x["changed"]) if "changed" in x else "%.4f (%+.4f)" % (x["iou"], -x["loss"])
    if x["groups"] != r["groups"]:
        text += ", %d groups" % x["groups"]
    return "**%s**" % text if missed(r, variant) else text


def total(results, variant):
    good = [(r, r["variants"][variant]) for r in results if "error" not in r["variants"][variant]]
    if not good:
        return ""
    if "changed" in good[0][1]:
        return "%.2f %%, most %.2f %%" % (100 * np.mean([x["changed"] for _, x in good]), 100 * max(x["changed"] for _, x in good))
    teeth = sum(r["teeth"] for r, _ in good)
    return "%.4f (%+.4f)" % tuple(sum(a * r["teeth"] for r, a in zip([r for r, _ in good], column)) / teeth
                                  for column in ([x["iou"] for _, x in good], [-x["loss"] for _, x in good]))


def summarise(results, options):
    text = ["Failed: %(scan)s: %(error)s" % r for r in results if "error" in r]
    good = [r for r in results if "error" not in r]
    for r in good:
        text += ["Failed: %s %s: %s" % (r["scan"], k, x["error"]) for k, x in r["variants"].items() if "error" in x]
    if not good:
        return "\n".join(text)
    for title, chosen in (("Same scan, told otherwise: share of the area with another label", lambda k: not k.startswith("noise")),
                          ("Noise, in mean edges: mean IoU (change)", lambda k: k.startswith("noise"))):
        names = [k for k in options.variants if chosen(k)]
        if not names:
            continue
        text += ["## " + title, "", "| scan | mean edge, mm | groups | IoU | " + " | ".join(names) + " |", "|" + "---|" * (len(names) + 4)]
        for r in good:
            text.append("| %s | %.2f | %d | %.4f | %s |" % (r["scan"], r["mean_edge"], r["groups"], r["iou"], " | ".join(cell(r, k) for k in names)))
        teeth = sum(r["teeth"] for r in good)
        text.append("| all | | %d | %.4f | %s |" % (sum(r["groups"] for r in good), sum(r["iou"] * r["teeth"] for r in good) / teeth,
                                                     " | ".join(total(good, k) for k in names)))
        judged = [m for r in good for k in names if (m := missed(r, k)) is not None]
        text += ["", "On target: %d of %d." % (judged.count(False), len(judged)), ""]
    return "\n".join(text)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--tool", default=ROOT + "/build/release/samples/ts-segment")
    a.add_argument("--scans", default=ROOT + "/../shared/data/scans")
    a.add_argument("--scorer", default=ROOT + "/../shared/tools/score_labels.py")
    a.add_argument("--variants", default=VARIANTS)
    a.add_argument("--only", default="")
    a.add_argument("--json")
    a.add_argument("--markdown")
    a.add_argument("--jobs", type=int, default=os.cpu_count())
    o = a.parse_args()
    o.variants = o.variants.split(",")
    if not os.path.isdir(o.scans):
        sys.exit("robustness.py: no scans at %s: this benchmark needs labelled scans" % o.scans)
    scans = [s for s in sorted(os.listdir(o.scans)) if o.only in s and os.path.exists(os.path.join(o.scans, s, "face_labels.txt"))]
    with concurrent.futures.ProcessPoolExecutor(o.jobs) as pool:
        results = list(pool.map(run, [o] * len(scans), scans))
    text = summarise(results, o)
    print(text)
    if o.json:
        json.dump(results, open(o.json, "w"), indent=1)
    if o.markdown:
        open(o.markdown, "w").write(text + "\n")
    if any("error" in x for r in results for x in [r, *r["variants"].values()]):
        sys.exit(1)


if __name__ == "__main__":
    main()
