"""Pictures of one click, in columns beside each other: the field, its contours, and what comes of them."""
import numpy as np

import plots
from library import Failure

EVERY = 4  # a contour in so many is drawn


def beside(arch, tooth):
    """For a picture of one tooth (FDI): the click on its top, the view on it from the cheek and from above, and what part to show."""
    up, middle = arch.scan.occlusal(), arch.v[arch.f[arch.reference == tooth]].mean((0, 1))
    out = middle - arch.v.mean(0)
    out -= up * (out @ up)
    return arch.top_of(tooth), (out / np.linalg.norm(out) + 0.9 * up, up), (middle, 9.0)


def compare(study, name, arch, tooth, ways):
    """A column for each of `ways` (title, preset, settings): the same click with each."""
    import draw
    at, view, around = beside(arch, tooth)
    figure, axes = draw.plt.subplots(3, len(ways), figsize=(2.6 * len(ways), 7), squeeze=False)
    for column, (title, preset, settings) in zip(axes.T, ways):
        segmentation = arch.scan.prepare(preset, **settings)
        try:
            click_on(column, arch, segmentation, segmentation.click(at), view, around)
        except Failure as e:
            title += ": " + e.status
            for ax in column:
                ax.axis("off")
        column[0].set_title(title, fontsize=9)
    figure.tight_layout(pad=0.3)
    draw.save(figure, plots.drawn(study, name))


def click_on(axes, arch, segmentation, click, view, around):
    """Three axes. Field and contours are on the library's mesh; blue is the tooth clicked, its constraints with it."""
    import draw
    v, f, u = arch.scan.positions(), arch.scan.triangles(), segmentation.field(click)
    info, held = segmentation.info(click), []
    for tooth, colour in ((info.target, "blue"), (info.neighbour, "red")):
        if tooth in segmentation.teeth():
            seeds = set(segmentation.seeds(tooth))
            held += [(tuple(p.position), colour, 3) for p in arch.scan.points() if p.group == tooth and p.vertex in seeds]
    contours = range(0, len(segmentation.contours_of(click)), EVERY)
    shown = {"view": view, "around": around, "pixels": 400}
    draw.show(axes[0], v, f, vertex_scalar=np.nan_to_num(u, nan=1.0), points=held, **shown)
    draw.show(axes[1], v, f, lines=[(line, "black", 0.5) for i in contours for line in segmentation.contour_lines(click, i)], **shown)
    draw.show(axes[2], arch.v, arch.f, labels=segmentation.labels(), **shown)
