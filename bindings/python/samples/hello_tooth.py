#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shortest way to a tooth: hello_tooth.py SCAN [X Y Z] prints the cut around the tooth at X Y Z (mm, on the surface), or
around the first one that the library proposes."""
import sys

import toothseg


def main(arguments):
    if len(arguments) not in (1, 4):
        sys.exit("usage: hello_tooth.py SCAN [X Y Z]")
    with toothseg.Context() as context, toothseg.Model.load(context, arguments[0]) as model, \
         toothseg.Features.detect(model) as features, toothseg.Segmentation(features) as segmentation:
        position = [float(a) for a in arguments[1:]] or segmentation.propose_clicks()[0]
        click = segmentation.click(position)
        for x, y, z in segmentation.cut(segmentation.click_info(click).target).positions:
            print(f"{x:.4f} {y:.4f} {z:.4f}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except toothseg.Error as e:
        sys.exit(f"hello_tooth: {e}")
