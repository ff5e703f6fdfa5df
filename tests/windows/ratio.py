#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""ratio.py LINUX WINDOWS SCAN FOLDER: how much longer ts-segment takes under Wine than on Linux, by its own report: the least of
five runs each, by turns. Printed, not judged: a machine that others use says little."""
import json
import pathlib
import subprocess
import sys


def times(command, scan, report):
    subprocess.run([*command, scan, "--auto", "--report", report], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    flat = {}

    def collect(value, path):
        if isinstance(value, dict):
            for key, inner in value.items():
                collect(inner, path + [key])
        elif isinstance(value, (int, float)) and any("ms" in part.split("_") for part in path):
            flat["/".join(path)] = float(value)

    collect(json.loads(pathlib.Path(report).read_text(encoding="utf-8")), [])
    return flat


linux, windows, scan, folder = sys.argv[1:5]
runs = {"linux": [], "wine": []}
for _ in range(5):
    runs["linux"].append(times([linux], scan, f"{folder}/linux.json"))
    runs["wine"].append(times(["wine", windows], scan, f"{folder}/wine.json"))
least = {name: {key: min(run[key] for run in all_runs) for key in all_runs[0]} for name, all_runs in runs.items()}
for key, native in least["linux"].items():
    if native > 0:
        print(f"time, {key}: Linux {native:.1f} ms, Wine {least['wine'][key]:.1f} ms, ratio {least['wine'][key] / native:.2f}")
