# SPDX-License-Identifier: Apache-2.0
"""What is installed, and where it finds the library."""
import os
import subprocess
import sys
import unittest

import fixture
import toothseg
from toothseg._library import lib

#: the package installed without the library
ALONE = os.environ.get("TOOTHSEG_TEST_ALONE")
LIBRARY = os.path.join(fixture.LIBRARIES, "libtoothseg.so")


@unittest.skipUnless(ALONE, "test.sh has not installed anything")
class Installed(unittest.TestCase):
    def alone(self, **environment):
        """What becomes of an import of the package that has no library inside, in an interpreter without the venv."""
        code = ("import toothseg, sys; from toothseg._library import lib\n"
                "print(toothseg.__version__, toothseg.fdi_to_universal(11), lib._name, toothseg.__file__)")
        clean = {n: v for n, v in os.environ.items() if n not in ("LD_LIBRARY_PATH", "TOOTHSEG_LIBRARY")}
        return subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True,
                              env={**clean, "PYTHONPATH": ALONE, **environment})

    def test_the_wheel_is_what_is_tested(self):
        folder = os.path.dirname(toothseg.__file__)
        self.assertTrue(folder.startswith(sys.prefix), folder)
        self.assertEqual(os.path.dirname(lib._name), folder)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))

    def test_named_by_the_environment(self):
        run = self.alone(TOOTHSEG_LIBRARY=LIBRARY)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.split()[:3], [toothseg.__version__, "8", LIBRARY])
        self.assertTrue(run.stdout.split()[3].startswith(ALONE))

    def test_by_the_systems_loader(self):
        run = self.alone(LD_LIBRARY_PATH=fixture.LIBRARIES)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.split()[2], "libtoothseg.so.0")

    def test_named_but_not_there(self):
        run = self.alone(TOOTHSEG_LIBRARY="/no/such/library.so", LD_LIBRARY_PATH=fixture.LIBRARIES)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("/no/such/library.so", run.stderr)
        self.assertIn("ImportError", run.stderr)

    def test_another_library(self):
        run = self.alone(TOOTHSEG_LIBRARY="libm.so.6")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("no toothseg library", run.stderr)

    @unittest.skipIf(any(os.path.exists(os.path.join(d, "libtoothseg.so.0")) for d in ("/usr/lib", "/usr/local/lib")),
                     "the system has the library")
    def test_nowhere(self):
        run = self.alone()
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("TOOTHSEG_LIBRARY", run.stderr)
