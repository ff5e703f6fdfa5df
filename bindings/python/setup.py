# SPDX-License-Identifier: Apache-2.0
"""All but the wheel's tag is in pyproject.toml: no extension module, so any Python 3; with the library inside, this platform."""
import glob

from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel

INSIDE = [p for end in ("so*", "dylib", "dll") for p in glob.glob("toothseg/*." + end)]


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return bool(INSIDE)


class Wheel(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(cmdclass={"bdist_wheel": Wheel}, distclass=WithLibrary)
