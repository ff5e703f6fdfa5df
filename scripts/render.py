#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws a dental arch as a figure: seen from the occlusal side and from the front, teeth coloured, cuts, numbers.

Needs only python3-numpy, python3-pil and fonts-dejavu-core; no display, no OpenGL.
"""
import argparse
import sys

import numpy as np
from PIL import Image, ImageDraw, ImageFont

GINGIVA = np.array([0.93, 0.66, 0.63])
PLAIN = np.array([0.90, 0.87, 0.80])
# Muted hues that keep apart from each other and from the gingiva; neighbours along the arch differ most.
PALETTE = np.array([
    [.42, .68, .84], [.96, .83, .47], [.55, .78, .55], [.71, .60, .84], [.98, .68, .42], [.47, .80, .78],
    [.88, .87, .60], [.55, .62, .86], [.72, .85, .48], [.93, .72, .83], [.40, .73, .66], [.84, .76, .60],
    [.62, .80, .93], [.80, .66, .92]])
INK = (38, 42, 50)


def fail(message):
    sys.exit(f"render: {message}")


# ---------------------------------------------------------------------------------------------------------- files

PLY_TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
             "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
             "double": "f8", "float64": "f8"}


def read_ply(path):
    """points, faces, per-face colours or None, per-vertex colours or None, labels of the faces or None."""
    with open(path, "rb") as f:
        data = f.read()
    end = data.find(b"end_header")
    if not data.startswith(b"ply") or end < 0:
        fail(f"{path}: not a PLY file")
    body = data.index(b"\n", end) + 1
    kind, elements = None, []
    for line in data[:end].decode("latin-1").splitlines():
        w = line.split()
        if w[:1] == ["format"]:
            kind = w[1]
        elif w[:1] == ["element"]:
            elements.append((w[1], int(w[2]), []))
        elif w[:1] == ["property"]:
            elements[-1][2].append(w[1:])
    text = data[body:].split() if kind == "ascii" else None
    order = ">" if kind == "binary_big_endian" else "<"
    at, found = (0 if text is not None else body), {}
    for name, count, properties in elements:
        lists = [p for p in properties if p[0] == "list"]
        if len(lists) > 1:
            fail(f"{path}: element {name} has more than one list")
        fields = []
        for p in properties:
            if p[0] == "list":
                fields += [("count", order + PLY_TYPES[p[1]]), ("corners", order + PLY_TYPES[p[2]], 3)]
            else:
                fields.append((p[1], order + PLY_TYPES[p[0]]))
        dtype = np.dtype(fields)
        if text is not None:
            width = sum(3 if f[0] == "corners" else 1 for f in fields)
            flat = np.array(text[at:at + width * count], dtype=float).reshape(count, width)
            rows, column = np.zeros(count, dtype), 0
            for f in fields:
                size = 3 if f[0] == "corners" else 1
                rows[f[0]] = flat[:, column:column + size] if size == 3 else flat[:, column]
                column += size
            at += width * count
        else:
            rows = np.frombuffer(data, dtype, count, at)
            at += dtype.itemsize * count
        if lists and count and not np.all(rows["count"] == 3):
            fail(f"{path}: only triangles are drawn")
        found[name] = rows

    def colours(rows):
        if rows is None or "red" not in (rows.dtype.names or ()):
            return None
        c = np.stack([rows[k].astype(float) for k in ("red", "green", "blue")], 1)
        return c / 255 if rows.dtype["red"].kind == "u" else c

    v, t = found.get("vertex"), found.get("face")
    if v is None or t is None:
        fail(f"{path}: no vertices or no faces")
    points = np.stack([v["x"], v["y"], v["z"]], 1).astype(float)
    labels = t["label"].astype(np.int64) if "label" in t.dtype.names else None
    return points, t["corners"].astype(np.int64), colours(t), colours(v), labels


def read_cuts(path):
    """Polylines of an OBJ file with v and l records."""
    points, lines = [], []
    with open(path) as f:
        for line in f:
            w = line.split()
            if w[:1] == ["v"]:
                points.append([float(x) for x in w[1:4]])
            elif w[:1] == ["l"]:
                ids = [int(x.split("/")[0]) for x in w[1:]]
                lines.append([i - 1 if i > 0 else len(points) + i for i in ids])
    points = np.array(points).reshape(-1, 3)
    return [points[i] for i in lines]


# ---------------------------------------------------------------------------------------------------------- camera

def unit(v):
    return v / np.linalg.norm(v)


def front_direction(points, up):
    """Towards the incisors. A horseshoe in plan is all but symmetric about its midline, and its open end has no
    material on it: so of all lines through the centroid the one with the least reflection error, and of its two ends
    the one on whose ray the material lies further out."""
    a = unit(np.cross(up, [1, 0, 0] if abs(up[0]) < 0.9 else [0, 1, 0]))
    b = np.cross(up, a)
    q = np.stack([points @ a, points @ b], 1)
    q = q[::max(1, len(q) // 200_000)]
    cells = np.unique(np.floor(q), axis=0)  # plan coverage, whatever the density of vertices
    q = cells - cells.mean(0)
    best, front = None, None
    size = 260
    image = np.zeros((size, size), bool)
    ij = np.clip(q.astype(int) + size // 2, 0, size - 1)
    image[ij[:, 0], ij[:, 1]] = True
    for angle in np.arange(0, np.pi, np.pi / 120):
        e = np.array([np.cos(angle), np.sin(angle)])
        mirrored = 2 * (q @ e)[:, None] * e - q
        ij = np.clip(np.round(mirrored).astype(int) + size // 2, 0, size - 1)
        overlap = image[ij[:, 0], ij[:, 1]].mean()
        if best is None or overlap > best:
            best, front = overlap, e
    near = np.abs(q @ np.array([-front[1], front[0]])) < 4
    along = (q @ front)[near]
    if along.sum() < 0:
        front = -front
    return unit(front[0] * a + front[1] * b)


class View:
    """Orthographic: `depth` points from the scene to the eye."""

    def __init__(self, points, depth, upward, width, height, margin):
        self.depth = unit(depth)
        self.right = unit(np.cross(upward, self.depth))
        self.upward = np.cross(self.depth, self.right)
        x, y = points @ self.right, points @ self.upward
        self.scale = min((width - 2 * margin) / (x.max() - x.min()), (height - 2 * margin) / (y.max() - y.min()))
        self.offset = np.array([width / 2 - self.scale * 0.5 * (x.max() + x.min()),
                                height / 2 + self.scale * 0.5 * (y.max() + y.min())])
        self.width, self.height = width, height

    def project(self, p):
        """Pixels right and down, and closeness to the eye in mm."""
        return np.stack([self.offset[0] + self.scale * (p @ self.right), self.offset[1] - self.scale * (p @ self.upward),
                         p @ self.depth], -1)


# ------------------------------------------------------------------------------------------------------ rasterising

def rasterise(screen, faces, width, height):
    """Closest face and barycentric coordinates per pixel. Faces are drawn in groups of like box size, all pixels of a
    group at once; one lexicographic maximum per pixel decides."""
    depth = np.full(width * height, -np.inf)
    owner = np.full(width * height, -1, np.int64)
    p = screen[faces]  # n, 3, 3
    low = np.clip(np.floor(p[:, :, :2].min(1)), 0, [width - 1, height - 1]).astype(np.int64)
    high = np.clip(np.ceil(p[:, :, :2].max(1)), 0, [width - 1, height - 1]).astype(np.int64)
    size = (high - low + 1).max(1)
    area = (p[:, 1, 0] - p[:, 0, 0]) * (p[:, 2, 1] - p[:, 0, 1]) - (p[:, 1, 1] - p[:, 0, 1]) * (p[:, 2, 0] - p[:, 0, 0])
    alive = np.abs(area) > 1e-12
    bounds = np.unique(np.concatenate([[0, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256, 512, 4096]]))
    for lo, hi in zip(bounds[:-1], bounds[1:]):
        group = np.flatnonzero(alive & (size > lo) & (size <= hi))
        step = max(1, 4_000_000 // (hi * hi))
        for start in range(0, len(group), step):
            ids = group[start:start + step]
            draw(ids, p[ids], low[ids], area[ids], min(hi, max(width, height)), width, height, depth, owner)
    return depth.reshape(height, width), owner.reshape(height, width)


def draw(ids, p, low, area, box, width, height, depth, owner):
    dy, dx = np.divmod(np.arange(box * box), box)
    x = low[:, 0, None] + dx
    y = low[:, 1, None] + dy
    px, py = x + 0.5, y + 0.5

    def edge(i, j):
        return ((p[:, j, 0] - p[:, i, 0])[:, None] * (py - p[:, i, 1][:, None]) -
                (p[:, j, 1] - p[:, i, 1])[:, None] * (px - p[:, i, 0][:, None])) / area[:, None]

    w2, w0 = edge(0, 1), edge(1, 2)
    w1 = 1 - w0 - w2
    hit = (w0 >= -1e-9) & (w1 >= -1e-9) & (w2 >= -1e-9) & (x < width) & (y < height)
    z = w0 * p[:, 0, 2][:, None] + w1 * p[:, 1, 2][:, None] + w2 * p[:, 2, 2][:, None]
    face = np.broadcast_to(ids[:, None], hit.shape)[hit]
    pixel, z = (y * width + x)[hit], z[hit]
    if len(pixel) == 0:
        return
    order = np.lexsort((-face, z, pixel))
    pixel, z, face = pixel[order], z[order], face[order]
    last = np.append(pixel[1:] != pixel[:-1], True)
    pixel, z, face = pixel[last], z[last], face[last]
    closer = z > depth[pixel]
    depth[pixel[closer]] = z[closer]
    owner[pixel[closer]] = face[closer]


def occlusion(depth, scale):
    """Darkens valleys: grooves, contacts, the gum line. Pixels 0.4, 1 and 2.4 mm away on opposite sides are compared with
    the middle, so that a plane stays bright however it is inclined; a step much deeper than that is another part of the
    arch in front, and casts nothing."""
    height, width = depth.shape
    covered = np.isfinite(depth)
    base = np.where(covered, depth, depth[covered].min() if covered.any() else 0).astype(np.float32)
    dark = np.zeros(depth.shape, np.float32)
    count = 6
    for ring, radius in enumerate((0.4, 1.0, 2.4)):
        reach = max(1, int(round(radius * scale)))
        padded = np.pad(base, reach, mode="edge")

        def rise(dx, dy):
            return (padded[reach + dy:reach + dy + height, reach + dx:reach + dx + width] - base) / radius

        for k in range(count):
            angle = np.pi * (k + ring / 3) / count
            dx, dy = int(round(reach * np.cos(angle))), int(round(reach * np.sin(angle)))
            a, b = rise(dx, dy), rise(-dx, -dy)
            near = np.clip(3 - np.maximum(a, b) / 1.5, 0, 1) * np.clip(3 - np.maximum(-a, -b) / 1.5, 0, 1)
            dark += np.clip(0.5 * (a + b), 0, 1) * near / count
    return np.where(covered, np.exp(-1.1 * dark), 1)


def vertex_normals(points, faces):
    n = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    total = np.zeros(points.shape)
    for k in range(3):
        for axis in range(3):
            total[:, axis] += np.bincount(faces[:, k], n[:, axis], len(points))
    return total / np.maximum(np.linalg.norm(total, axis=1), 1e-12)[:, None]


def shade(view, scene, lines_width):
    points, faces, normals, face_colour, vertex_colour, cuts = scene
    screen = view.project(points)
    depth, owner = rasterise(screen, faces, view.width, view.height)
    seen = owner >= 0
    f = owner[seen]
    yy, xx = np.nonzero(seen)
    p = screen[faces[f]]
    area = (p[:, 1, 0] - p[:, 0, 0]) * (p[:, 2, 1] - p[:, 0, 1]) - (p[:, 1, 1] - p[:, 0, 1]) * (p[:, 2, 0] - p[:, 0, 0])

    def weight(i, j):
        return ((p[:, j, 0] - p[:, i, 0]) * (yy + 0.5 - p[:, i, 1]) - (p[:, j, 1] - p[:, i, 1]) * (xx + 0.5 - p[:, i, 0])) / area

    w = np.stack([weight(1, 2), weight(2, 0), weight(0, 1)], 1)
    n = (w[:, :, None] * normals[faces[f]]).sum(1)
    n /= np.maximum(np.linalg.norm(n, axis=1), 1e-12)[:, None]
    # Back sides, seen through an open rim, are drawn as the inside: dim, no highlight.
    facing = n @ view.depth
    back = np.cross(p[:, 1, :2] - p[:, 0, :2], p[:, 2, :2] - p[:, 0, :2]) > 0  # y runs down
    colour = face_colour[f] if vertex_colour is None else (w[:, :, None] * vertex_colour[faces[f]]).sum(1)
    key = unit(0.85 * view.depth + 0.55 * view.upward - 0.45 * view.right)
    fill = unit(0.6 * view.depth - 0.2 * view.upward + 0.8 * view.right)
    n = np.where(back[:, None], -n, n)
    diffuse = 0.36 + 0.58 * np.clip(n @ key, 0, None) + 0.22 * np.clip(n @ fill, 0, None)
    rim = 0.10 * (1 - np.clip(np.abs(facing), 0, 1)) ** 3
    gloss = np.clip(n @ unit(key + view.depth), 0, None) ** 45 * 0.22
    coarse = occlusion(depth[::2, ::2], view.scale / 2)
    ao = np.repeat(np.repeat(coarse, 2, 0), 2, 1)[:view.height, :view.width][seen]
    linear = np.clip(colour, 0, 1) ** 2.0 * (diffuse * ao + rim)[:, None] + (gloss * ao * ~back)[:, None]
    linear = np.where(back[:, None], 0.35 * linear + 0.12, linear)
    image = np.ones((view.height, view.width, 3))
    image[seen] = np.clip(linear, 0, 1) ** (1 / 2.0)
    picture = Image.fromarray((255 * image + 0.5).astype(np.uint8))
    draw_cuts(picture, depth, view, cuts, lines_width)
    return picture, depth, screen


def draw_cuts(picture, depth, view, cuts, width):
    """Segments that the depth buffer does not hide; what lies within 0.35 mm of the surface counts as on it."""
    pen = ImageDraw.Draw(picture)
    for line in cuts:
        q = view.project(line)
        x = np.clip(q[:, 0].astype(int), 0, view.width - 1)
        y = np.clip(q[:, 1].astype(int), 0, view.height - 1)
        visible = q[:, 2] > depth[y, x] - 0.35
        for i in range(len(q) - 1):
            if visible[i] and visible[i + 1]:
                pen.line([tuple(q[i, :2]), tuple(q[i + 1, :2])], fill=(30, 26, 30), width=width, joint="curve")
        r = 0.5 * width - 0.5
        for i in np.flatnonzero(visible):
            pen.ellipse([q[i, 0] - r, q[i, 1] - r, q[i, 0] + r, q[i, 1] + r], fill=(30, 26, 30))


# ---------------------------------------------------------------------------------------------------------- figure

def font(size, bold=False):
    name = "DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf"
    try:
        return ImageFont.truetype(f"/usr/share/fonts/truetype/dejavu/{name}", size)
    except OSError:
        return ImageFont.load_default()


def number_teeth(picture, view, depth, points, faces, labels, up, size):
    """A number on each tooth that shows at least a fifth of the area it has."""
    pen, face = ImageDraw.Draw(picture), font(size, bold=True)
    centres = points[faces].mean(1)
    n = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    for label in np.unique(labels):
        if label == 0:
            continue
        mine = labels == label
        q = view.project(centres[mine])
        inside = (q[:, 0] >= 0) & (q[:, 1] >= 0) & (q[:, 0] < view.width) & (q[:, 1] < view.height)
        x, y = np.clip(q[:, 0].astype(int), 0, view.width - 1), np.clip(q[:, 1].astype(int), 0, view.height - 1)
        area = np.clip(n[mine] @ view.depth, 0, None) * (inside & (q[:, 2] > depth[y, x] - 0.3))
        whole = 0.5 * np.linalg.norm(n[mine], axis=1).sum()
        if 0.5 * area.sum() < 0.12 * whole or area.sum() == 0:
            continue
        at = (area[:, None] * q[:, :2]).sum(0) / area.sum()
        pen.text(tuple(at), str(label), font=face, fill=(20, 22, 28), anchor="mm", stroke_width=max(2, size // 7),
                 stroke_fill=(255, 255, 255))


def tooth_colours(labels):
    colour = np.tile(GINGIVA, (len(labels), 1))
    for i, label in enumerate(sorted(set(labels.tolist()) - {0})):
        colour[labels == label] = PALETTE[i % len(PALETTE)]
    return colour


def direction(text):
    v = np.array([float(x) for x in text.split(",")])
    if v.shape != (3,) or not np.linalg.norm(v) > 0:
        raise argparse.ArgumentTypeError("three numbers, not all 0")
    return unit(v)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", help="PLY with triangles; colours a face or a vertex are used unless --labels is given")
    parser.add_argument("out", help="PNG")
    parser.add_argument("--labels", help="text, an integer a face, 0 = gingiva, for colours and numbers; else a face property `label` is taken for the numbers")
    parser.add_argument("--cuts", help="OBJ with polylines (v and l records)")
    parser.add_argument("--up", type=direction, default=np.array([0., 0, 1]), metavar="X,Y,Z", help="occlusal direction")
    parser.add_argument("--front", type=direction, metavar="X,Y,Z", help="towards the incisors; found if not given")
    parser.add_argument("--upper", action="store_true", help="show the front view of an upper jaw crowns down")
    parser.add_argument("--title", default="")
    parser.add_argument("--note", default="", help="a second, smaller line")
    parser.add_argument("--no-numbers", action="store_true")
    parser.add_argument("--side", action="store_true", help="a third view, from the side")
    parser.add_argument("--plain", action="store_true", help="one colour: shape only")
    parser.add_argument("--size", type=int, default=720, help="height of the views in pixels")
    args = parser.parse_args()

    points, faces, face_colour, vertex_colour, labels = read_ply(args.mesh)
    if args.labels:
        labels = np.loadtxt(args.labels, dtype=np.int64, ndmin=1)
        if len(labels) != len(faces):
            fail(f"{args.labels}: {len(labels)} labels for {len(faces)} faces")
        face_colour, vertex_colour = tooth_colours(labels), None
    if args.plain or (face_colour is None and vertex_colour is None):
        face_colour, vertex_colour = np.tile(PLAIN, (len(faces), 1)), None
    elif face_colour is not None:
        vertex_colour = None
    cuts = read_cuts(args.cuts) if args.cuts else []
    normals = vertex_normals(points, faces)
    up = unit(args.up)
    front = args.front if args.front is not None else front_direction(points, up)
    front = unit(front - (front @ up) * up)
    side = np.cross(up, front)

    k = 2  # drawn at twice the size and reduced: smooth edges
    h = args.size * k
    head = (70 if args.note else 48) * k if args.title or args.note else 0
    sense = -1 if args.upper else 1
    views = [(up, front, 1.0), (unit(front + 0.42 * up), sense * up, 1.12)]
    if args.side:
        views.append((unit(side + 0.15 * up), sense * up, 1.0))
    scene = (points, faces, normals, face_colour, vertex_colour, cuts)
    pictures = []
    for depth_axis, upward, aspect in views:
        view = View(points, depth_axis, upward, int(h * aspect), h, 26 * k)
        picture, depth, _ = shade(view, scene, 3 * k // 2)
        if labels is not None and not args.no_numbers:
            number_teeth(picture, view, depth, points, faces, labels, up, 11 * k)
        pictures.append(picture)
    figure = Image.new("RGB", (sum(p.width for p in pictures), h + head), "white")
    x = 0
    for p in pictures:
        figure.paste(p, (x, head))
        x += p.width
    pen = ImageDraw.Draw(figure)
    if args.title:
        pen.text((26 * k, 14 * k), args.title, font=font(19 * k, bold=True), fill=INK)
    if args.note:
        pen.text((26 * k, 42 * k), args.note, font=font(13 * k), fill=(96, 102, 112))
    figure.resize((figure.width // k, figure.height // k), Image.LANCZOS).save(args.out, optimize=True)


if __name__ == "__main__":
    main()
