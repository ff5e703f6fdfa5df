"""Plots of the study's figures, and where its pictures go: docs/study/, or with --quick the study's own folder."""
import os
import shutil

HERE = os.path.dirname(os.path.abspath(__file__))
DOCS = os.path.join(os.path.dirname(os.path.dirname(HERE)), "docs", "study")


def drawn(study, name):
    """The path of a picture as it is drawn, in the study's folder, where it stays for the next run."""
    folder = os.path.join(study.folder, "pictures")
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, name + ".png")


def placed(study, name, text):
    """Lines of the report that show a picture, put where the report finds it; none if it was not drawn."""
    path = drawn(study, name)
    if not os.path.exists(path):
        return []
    if study.quick:
        return ["![%s](pictures/%s.png)" % (text, name), ""]
    os.makedirs(DOCS, exist_ok=True)
    shutil.copyfile(path, os.path.join(DOCS, name + ".png"))
    return ["![%s](study/%s.png)" % (text, name), ""]


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
