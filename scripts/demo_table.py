#!/usr/bin/python3
"""Prints what ts-segment did as a small table: demo_table.py REPORT.json [--mesh M.ply --truth T.txt --labels L.txt]"""
import argparse
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench"))


def main():
    a = argparse.ArgumentParser(description=__doc__)
    a.add_argument("report")
    a.add_argument("--mesh")
    a.add_argument("--truth")
    a.add_argument("--labels")
    o = a.parse_args()
    r = json.load(open(o.report))
    ms = r["ms"]
    done = [c for c in r["clicks"] if c["status"] == "TS_OK"]
    rows = [("faces", "%d" % r["intake"]["faces"]), ("teeth", "%d" % r["counts"]["teeth"]),
            ("clicks", "%d (%d failed)" % (r["counts"]["clicks"], r["counts"]["failed_clicks"])),
            ("prepare, ms", "%.0f (intake %.0f, features %.0f, weights %.0f, factorise %.0f)" % (
                ms["intake"] + ms["features"] + ms["weights"] + ms["factorise"], ms["intake"], ms["features"],
                ms["weights"], ms["factorise"])),
            ("a click, ms", "%.1f" % (sum(c["ms"]["total"] for c in done) / max(1, len(done))))]
    if o.truth:
        import numpy as np
        import score
        v, f = score.read_ply(o.mesh)
        teeth, iou, dice, false = score.match(score.areas(v, f), np.loadtxt(o.truth, dtype=int), np.loadtxt(o.labels, dtype=int))
        rows += [("IoU, mean / least", "%.3f / %.3f" % (iou.mean(), iou.min())),
                 ("IoU a tooth", "  ".join("%d: %.3f" % x for x in zip(teeth, iou)))]
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        print("%-*s  %s" % (width, name, value))


if __name__ == "__main__":
    main()
