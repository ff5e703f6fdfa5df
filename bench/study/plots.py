"""Plots of the study's figures, and where its pictures go."""
import os
import shutil


def drawn(study, name):
    """The path of a picture as it is drawn, in the study's folder, where it stays for the next run."""
    folder = os.path.join(study.folder, "pictures")
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name + ".png")


def placed(study, name, text):
    """Lines of the report that show a picture; none if it was not drawn. A report outside of the study's folder has its pictures
    beside it: docs/study.md in docs/study."""
    path, beside = drawn(study, name), os.path.dirname(study.report)
    if not os.path.exists(path):
        return []
    if os.path.commonpath([study.folder, study.report]) != study.folder:
        folder = os.path.splitext(study.report)[0]
        os.makedirs(folder, exist_ok=True)
        path = shutil.copyfile(path, os.path.join(folder, name + ".png"))
    return ["![%s](%s)" % (text, os.path.relpath(path, beside)), ""]


def lines(study, name, panels):
    """Panels side by side: (title, label of x, logarithmic, {line: (x, y)}), y being IoU."""
    import draw
    figure, axes = draw.plt.subplots(1, len(panels), figsize=(5.5 * len(panels), 3.6), squeeze=False, sharey=True)
    for ax, (title, label, logarithmic, curves) in zip(axes[0], panels):
        for place, (curve, (x, y)) in enumerate(curves.items()):
            ax.plot(x, y, "-o" if place % 2 == 0 else "--s", color="C%d" % (place // 2), label=curve)
        ax.set(title=title, xlabel=label, xscale="log" if logarithmic else "linear",
               xticks=sorted({a for x, _ in curves.values() for a in x}))
        ax.get_xaxis().set_major_formatter(lambda a, _: "%.0fk" % (a / 1000) if a >= 1000 else "%g" % a)
        ax.minorticks_off()
        ax.grid(alpha=0.3)
        ax.legend(fontsize=8)
    axes[0][0].set_ylabel("mean IoU")
    figure.tight_layout()
    draw.save(figure, drawn(study, name))


def bars(study, name, groups, stacks, label):
    """Stacked bars: for each of `groups` a bar for each of `stacks`, {bar: {part: one value a group}}; logarithms would hide what
    a stack is made of, so each kind of bar has a panel."""
    import draw
    figure, axes = draw.plt.subplots(1, len(stacks), figsize=(5.5 * len(stacks), 3.6), squeeze=False)
    for ax, (bar, parts) in zip(axes[0], stacks.items()):
        base = [0.0] * len(groups)
        for part, values in parts.items():
            ax.bar(groups, values, bottom=base, label=part)
            base = [a + b for a, b in zip(base, values)]
        ax.set(title=bar, ylabel=label, ylim=(0, 1.25 * max(base)))
        ax.legend(fontsize=8, loc="upper left")
    figure.tight_layout()
    draw.save(figure, drawn(study, name))
