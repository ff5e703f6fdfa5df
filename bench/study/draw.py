"""Pictures of meshes in matplotlib figures. The surface is drawn by scripts/render.py's depth buffer, which takes a million
triangles in seconds; lines and points are matplotlib's own, so that they stay sharp, less what the surface hides."""
import io
import os
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from PIL import Image  # noqa: E402

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
import render  # noqa: E402

FIELD = plt.get_cmap("RdYlBu_r")  # 0 blue, 1 red, as the paper's field pictures
OCCLUSAL = ((0, 0, 1), (0, -1, 0))  # view and up: on the crowns, incisors below, as the paper's Fig. 6
FRONT = ((0, 1, 0.42), (0, 0, 1))
HIDDEN = 0.35  # mm behind the surface seen there
LARGEST = 400_000  # bytes a picture


def label_colours(labels):
    """A colour a face; a label keeps its own whatever other labels there are, 0 is gingiva."""
    labels = np.asarray(labels)
    return np.where((labels == 0)[:, None], render.GINGIVA, render.PALETTE[labels % len(render.PALETTE)])


def show(ax, v, f, *, labels=None, face_color=None, vertex_scalar=None, lines=(), points=(), view=OCCLUSAL, around=None,
         pixels=700, cmap=FIELD, limits=(0, 1)):
    """Draws the mesh on `ax`, seen along no perspective from `view` = (towards the eye, upward).

    Colour: `labels` a face, `face_color` (n x 3), or `vertex_scalar` through `cmap` over `limits`; else plain. `lines`: pairs
    or triples (xyz, colour, width in points). `points`: triples (xyz, colour, size in points). `around`: (centre, radius in mm)
    to show a part only. `pixels`: the longer side of the picture of the surface."""
    v, f = np.asarray(v, float), np.asarray(f)
    eye, upward = (render.unit(np.asarray(a, float)) for a in view)
    right = render.unit(np.cross(upward, eye))
    upward = np.cross(eye, right)
    flat = np.stack([v @ right, v @ upward], 1)
    if around is None:
        low, high = flat.min(0) - 1, flat.max(0) + 1
        part = np.arange(len(f))
    else:
        middle = np.array([np.dot(around[0], right), np.dot(around[0], upward)])
        low, high = middle - around[1], middle + around[1]
        corners = flat[f]
        part = np.flatnonzero(((corners.max(1) >= low) & (corners.min(1) <= high)).all(1))
    width, height = np.maximum(2, np.round(pixels * (high - low) / (high - low).max())).astype(int)
    camera = render.View(np.array([low, high]) @ np.array([right, upward]), eye, upward, width, height, 0)
    face_colour, vertex_colour = None, None
    if vertex_scalar is not None:
        value = np.asarray(vertex_scalar, float)
        vertex_colour = cmap(np.clip((value - limits[0]) / (limits[1] - limits[0]), 0, 1))[:, :3]
        vertex_colour[~np.isfinite(value)] = render.PLAIN  # pieces of the mesh that no constraint is on
    elif labels is not None:
        face_colour = label_colours(np.asarray(labels)[part])
    elif face_color is not None:
        face_colour = np.asarray(face_color, float)[part]
    else:
        face_colour = np.tile(render.PLAIN, (len(part), 1))
    scene = (v, f[part], render.vertex_normals(v, f), face_colour, vertex_colour, [])
    image, depth, _ = render.shade(camera, scene, 1)
    ax.imshow(image, extent=(low[0], high[0], low[1], high[1]), interpolation="antialiased", zorder=0)

    def seen(p):
        q = camera.project(p)
        x, y = q[:, 0].astype(int), q[:, 1].astype(int)
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        return inside & (q[:, 2] > depth[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)] - HIDDEN)

    for xyz, colour, *wide in lines:
        on, at = seen(xyz), np.stack([xyz @ right, xyz @ upward], 1)
        keep = on[:-1] & on[1:]
        ax.add_collection(LineCollection(np.stack([at[:-1], at[1:]], 1)[keep], colors=[colour],
                                         linewidths=wide[0] if wide else 1.0, capstyle="round", zorder=2))
    for xyz, colour, size in points:
        xyz = np.asarray(xyz, float).reshape(-1, 3)
        on = seen(xyz)
        ax.plot(xyz[on] @ right, xyz[on] @ upward, "o", color=colour, markersize=size, markeredgecolor="black",
                markeredgewidth=0.5, zorder=3)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    ax.axis("off")


def few_colours(image):
    """256 of them, fitted to a part of the pixels, for speed."""
    small = image.resize((image.width // 4, image.height // 4), Image.Resampling.NEAREST)
    palette = small.quantize(256, method=Image.Quantize.MEDIANCUT, kmeans=1)
    return image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)


def save(figure, path, dpi=110):
    """A PNG; with 256 colours, then smaller, until it is under the limit."""
    few = False
    while True:
        raw, picture = io.BytesIO(), io.BytesIO()
        figure.savefig(raw, format="png", dpi=dpi, facecolor="white")
        image = Image.open(raw).convert("RGB")
        (few_colours(image) if few else image).save(picture, "PNG", optimize=True)
        if picture.tell() <= LARGEST:
            break
        few, dpi = True, dpi * 0.85 if few else dpi
    plt.close(figure)
    with open(path, "wb") as out:
        out.write(picture.getvalue())
