#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""test_hardening.py CC CXX FOLDER: does hardening.py see what is built wrongly? Each case breaks one rule, and it alone."""
import pathlib
import subprocess
import sys
import unittest

import hardening

CC, CXX, FOLDER = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
CHECKED = """#include <string.h>
#include <stdlib.h>
int length(const char *text) {
  char copy[64];
  strcpy(copy, text);
  return (int)strlen(copy);
}
int number = 7;
"""
HARDENED = ["-O2", "-fPIC", "-fstack-protector-strong", "-U_FORTIFY_SOURCE", "-D_FORTIFY_SOURCE=2"]
LINKED = ["-shared", "-Wl,-z,relro,-z,now", "-Wl,-z,noexecstack"]


def build(name, text, compiler, *options):
    source, out = FOLDER / name, FOLDER / (name + ".out")
    source.write_text(text)
    subprocess.run([compiler, *options, str(source), "-o", str(out)], check=True)
    return str(out)


class Shared(unittest.TestCase):
    def broken(self, *options, text="", name="case.c"):
        path = build(name, CHECKED + text, CC, *HARDENED, *LINKED, *options)
        return [rule for rule, _ in hardening.faults(path, {})]

    def test_sound(self):
        self.assertEqual(self.broken(), [])

    def test_relro(self):
        self.assertEqual(self.broken("-Wl,-z,norelro"), ["relro"])

    def test_bind_now(self):
        self.assertEqual(self.broken("-Wl,-z,lazy"), ["bind_now"])

    def test_stack(self):
        self.assertEqual(self.broken("-Wl,-z,execstack"), ["stack"])

    def test_segments(self):
        text = '__asm__(".section .both,\\"awx\\",@progbits\\n.byte 0\\n.text");'
        self.assertEqual(self.broken(text=text), ["segments"])

    def test_textrel(self):
        text = '__asm__(".text\\n.quad number\\n");'
        self.assertEqual(self.broken("-Wl,-z,notext", text=text), ["textrel"])

    def test_protector(self):
        self.assertEqual(self.broken("-fno-stack-protector"), ["protector"])

    def test_fortify(self):
        self.assertEqual(self.broken("-U_FORTIFY_SOURCE"), ["fortify"])


class Objects(unittest.TestCase):
    def faults(self, text, allowed=()):
        path = build("case.cpp", text, CXX, "-O1", "-fPIC", "-std=c++17", "-c")
        return hardening.faults(path, dict.fromkeys(allowed, ""))

    def rules(self, text, allowed=()):
        return [rule for rule, _ in self.faults(text, allowed)]

    def test_sound(self):
        self.assertEqual(self.rules("""
            struct Base { virtual ~Base(); };
            Base::~Base() {}
            extern const char *const names[] = {"a table", "of texts"};
            const Base &base() { static const int size = sizeof(Base); static_assert(size > 0); return *(const Base *)names; }
            """), [])

    def test_each_kind_of_global(self):
        for text in ("int of_all = 1;", "int of_all;", "static int of_all; int next() { return ++of_all; }",
                     "int next() { static int of_all = 1; return ++of_all; }", "thread_local int of_all;",
                     "thread_local int of_all = 2;", "template <class T> T of_all = 3; int next() { return ++of_all<int>; }",
                     "inline int of_all = 4; int next() { return ++of_all; }", "const char *of_all = \"text\";"):
            found = self.faults(text)
            self.assertEqual([rule for rule, _ in found], ["globals"], text)
            self.assertIn("of_all", found[0][1])

    def test_common(self):
        path = build("common.c", "int of_all;", CC, "-fcommon", "-c")
        self.assertEqual([rule for rule, _ in hardening.faults(path, {})], ["globals"])

    def test_made_once(self):
        text = "int make(); int once() { static const int made = make(); return made; }"
        self.assertEqual(self.rules(text), ["globals", "globals"])  # itself and its guard
        self.assertEqual(self.rules(text, ["once()::made"]), [])

    def test_allowed_and_gone(self):
        self.assertEqual(self.rules("int f() { return 1; }", ["once()::made"]), ["allowed"])

    def test_initialiser(self):
        self.assertEqual(self.rules("int make(); namespace { [[gnu::constructor]] void load() { make(); } }"), ["initialiser"])


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
