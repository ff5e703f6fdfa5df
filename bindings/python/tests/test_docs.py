# SPDX-License-Identifier: Apache-2.0
"""The Python in README.md and in the five minutes runs."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

import fixture
import toothseg


class Docs(unittest.TestCase):
    def run_blocks(self, file):
        with open(file, encoding="utf-8") as f:
            blocks = re.findall(r"^```python\n(.*?)^```", f.read(), re.M | re.S)
        self.assertGreater(len(blocks), 0)
        with tempfile.TemporaryDirectory(dir=fixture.FOLDER) as folder, \
             toothseg.Model.load(fixture.context(), fixture.arch()) as model, toothseg.Features(model) as none:
            none.add_point(model.positions()[0])
            with toothseg.Segmentation(none) as s:  # to have the arch in the form that is asked for
                s.save(os.path.join(folder, "scan.stl"), toothseg.OutputFormat.STL)
            os.mkdir(os.path.join(folder, "build"))
            os.symlink(fixture.arch(), os.path.join(folder, "build", "scan.ply"))
            run = subprocess.run([sys.executable, "-c", "\n".join(blocks)], cwd=folder, capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            return os.listdir(folder) + os.listdir(os.path.join(folder, "build"))

    def test_readme(self):
        made = self.run_blocks(os.path.join(fixture.PYTHON, "README.md"))
        self.assertIn("tooth_17.stl", made)
        self.assertIn("session.json", made)

    def test_five_minutes(self):
        made = self.run_blocks(os.path.join(fixture.REPOSITORY, "docs", "five-minutes-python.md"))
        self.assertLessEqual({"tooth.stl", "teeth.glb", "session.json"}, set(made))
