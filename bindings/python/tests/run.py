#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs all tests, or those of the modules that are named; the last line counts them."""
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


class Result(unittest.TextTestResult):
    passed = 0

    def addSuccess(self, test):
        super().addSuccess(test)
        self.passed += 1


def main():
    sys.path[0] = HERE  # and not the folder above, so that it is the installed package that is tested
    loader = unittest.TestLoader()
    suite = loader.loadTestsFromNames(sys.argv[1:]) if sys.argv[1:] else loader.discover(HERE)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2, resultclass=Result).run(suite)
    failed = len(result.failures) + len(result.errors) + len(result.unexpectedSuccesses)
    print(f"{result.passed} passed, {failed} failed")
    sys.exit(failed != 0 or result.passed == 0 or not result.wasSuccessful())


if __name__ == "__main__":
    main()
