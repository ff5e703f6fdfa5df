#!/usr/bin/python3
"""Prints what ts-segment did: demo_table.py REPORT.json [--mesh M.ply --truth T.txt --labels L.txt] [--caption]

A small table; with --caption two lines for the picture, the occlusal direction and a summary. Needs python3-numpy where the
truth is given.
"""
import argparse
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench"))


def overlap(options):
    """FDI numbers and intersections over union."""
    import numpy as np
    import score
    v, f = score.read_ply(options.mesh)
    truth, labels = (np.loadtxt(name, dtype=int) for name in (options.truth, options.labels))
    return score.match(score.areas(v, f), truth, labels)[:2]


def main():
    a = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    a.add_argument("report")
    a.add_argument("--mesh")
    a.add_argument("--truth")
    a.add_argument("--labels")
    a.add_argument("--caption", action="store_true")
    o = a.parse_args()
    with open(o.report) as f:
        r = json.load(f)
    ms, counts = r["ms"], r["counts"]
    done = [c["ms"]["total"] for c in r["clicks"] if c["status"] == "TS_OK"]
    click = "%.0f ms" % (sum(done) / len(done)) if done else "-"
    fdi, iou = overlap(o) if o.truth else ([], None)
    if o.caption:
        print(",".join("%.9g" % x for x in r["occlusal"]))
        print("%d faces, %d teeth, %d clicks, %s a click" % (r["intake"]["faces"], counts["teeth"], counts["clicks"], click) +
              (", IoU %.3f" % iou.mean() if o.truth else ""))
        return
    steps = ("intake", "features", "weights", "factorise")
    rows = [("faces", "%d" % r["intake"]["faces"]), ("teeth", "%d" % counts["teeth"]),
            ("clicks", "%d" % counts["clicks"] + (", %d failed" % counts["failed_clicks"] if counts["failed_clicks"] else "")),
            ("prepared once in", "%.0f ms (%s)" % (sum(ms[s] for s in steps), ", ".join("%s %.0f" % (s, ms[s]) for s in steps))),
            ("a click", click + " (longest %.0f ms)" % max(done) if done else click)]
    if o.truth:
        rows += [("IoU, mean / least", "%.3f / %.3f" % (iou.mean(), iou.min())),
                 ("IoU by FDI number", "  ".join("%d: %.3f" % x for x in zip(fdi[:7], iou[:7])))]
        rows += [("", "  ".join("%d: %.3f" % x for x in zip(fdi[i:i + 7], iou[i:i + 7]))) for i in range(7, len(fdi), 7)]
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        print("%-*s  %s" % (width, name, value))


if __name__ == "__main__":
    main()
