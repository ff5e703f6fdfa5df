"""The synthetic arches of the study, made once each and kept in the study's folder; clicks on them."""
import hashlib
import json
import os
import subprocess
import sys
from collections import namedtuple

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
import accuracy  # noqa: E402
import score  # noqa: E402

Mesh = namedtuple("Mesh", "path labels")


def tool(study, name):
    """make-arch and ts-segment are samples, built against the installed library; the rest is built with it."""
    for folder in ("samples", "bench"):
        path = os.path.join(study.build, folder, name)
        if os.path.exists(path):
            return path
    return None


def digest(path):
    with open(path, "rb") as f:
        return hashlib.sha256(f.read()).hexdigest()[:16]


def made(study, maker, inputs, command):
    """The mesh that `command(path, labels)` makes, unless it is there already."""
    key = hashlib.sha256(json.dumps([inputs, digest(maker)], sort_keys=True).encode()).hexdigest()[:16]
    folder = os.path.join(study.folder, "meshes")
    os.makedirs(folder, exist_ok=True)
    mesh = Mesh(os.path.join(folder, key + ".ply"), os.path.join(folder, key + ".txt"))
    if not os.path.exists(mesh.path):
        new = Mesh(mesh.path[:-4] + ".%d.ply" % os.getpid(), mesh.labels + ".%d" % os.getpid())
        done = subprocess.run(command(*new), capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError("%s: %s" % (os.path.basename(maker), done.stderr.strip()))
        os.replace(new.labels, mesh.labels)  # the mesh last: where it is, all is
        os.replace(new.path, mesh.path)
    return mesh


def arch(study, jaw, crowding, triangles, seed, missing="", noise=0):
    maker = tool(study, "make-arch")
    arguments = ["--jaw", jaw, "--crowding", crowding, "--triangles", str(triangles), "--seed", str(seed)]
    arguments += ["--missing", missing] if missing else []
    arguments += ["--noise", str(noise), "--isotropic"] if noise else []
    return made(study, maker, arguments, lambda path, labels: [maker, path, "--labels", labels, *arguments])


def decimated(study, spec, faces):
    """The arch with as many faces as said."""
    maker, whole = tool(study, "ts-decimate"), arch(study, **spec)
    return made(study, maker, [whole.path, faces], lambda path, labels: [
        maker, whole.path, str(faces), path, "--labels", whole.labels, "--out-labels", labels])


def make(study, spec, faces=None):
    """A piece of its own for what takes long: the mesh, and how large it came out."""
    mesh = decimated(study, spec, faces) if faces else arch(study, **spec)
    return {"path": mesh.path, **size_of(mesh)}


def size_of(mesh):
    with open(mesh.path, "rb") as f:
        head = f.read(1000).split(b"end_header")[0].decode()
    count = {w[1]: int(w[2]) for w in (line.split() for line in head.splitlines()) if w[0] == "element"}
    return {"vertices": count["vertex"], "triangles": count["face"]}


def read(mesh):
    v, f = score.read_ply(mesh.path)
    return v, f, np.fromfile(mesh.labels, dtype=np.int64, sep="\n")


def clicks(study, v, f, reference, how, seed):
    """N/2 clicks (`pairs`; rounded up), or one a tooth (`each`): 3 coordinates, and the teeth that they are on."""
    path = os.path.join(study.folder, "clicks.%d.txt" % os.getpid())
    teeth = accuracy.clicks_for(score, v, f, reference, how, seed, path)
    rows = np.loadtxt(path, ndmin=2)
    os.remove(path)
    return rows[:, :3], teeth
