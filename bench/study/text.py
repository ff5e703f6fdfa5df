"""Numbers and tables as the report has them."""
import math


def number(x, digits=3):
    """Fixed digits; a dash where nothing was measured."""
    return "-" if x is None or isinstance(x, float) and not math.isfinite(x) else "%.*f" % (digits, x)


def ms(x):
    """Three figures that count."""
    if x is None or isinstance(x, float) and not math.isfinite(x):
        return "-"
    return "%.0f" % x if abs(x) >= 100 else "%.3g" % x


def table(head, rows):
    out = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(out + ["| " + " | ".join(str(x) for x in row) + " |" for row in rows])
