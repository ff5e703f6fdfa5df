#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of generate.py and of what pack.py made: test_tools.py PACKAGE PROGRAMS SCAN SCRATCH. Runs a sample against the package."""
import copy
import importlib.util
import json
import os
import pty
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as tree
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE, PROGRAMS, SCAN, SCRATCH = sys.argv[1:5]

specification = importlib.util.spec_from_file_location('generate', os.path.join(HERE, '..', 'generate.py'))
generate = importlib.util.module_from_spec(specification)
specification.loader.exec_module(generate)


def description():
    with open(generate.ABI, encoding='utf-8') as file:
        return json.load(file)


class Generator(unittest.TestCase):
    def test_committed_files_are_up_to_date(self):
        result = subprocess.run([sys.executable, generate.__file__, '--check'])
        self.assertEqual(result.returncode, 0)

    def test_new_functions_structs_and_enums_are_taken(self):
        data = description()
        function = copy.deepcopy(next(f for f in data['functions'] if f['name'] == 'ts_get_tooth'))
        function['name'] = 'ts_get_crown'
        function['arguments'][-1]['type'].update(base='ts_crown_info', spelling='ts_crown_info *')
        struct = copy.deepcopy(next(s for s in data['structs'] if s['name'] == 'ts_tooth_info'))
        struct['name'] = 'ts_crown_info'
        enum = copy.deepcopy(next(e for e in data['enums'] if e['name'] == 'ts_jaw'))
        enum['name'] = 'ts_side'
        data['functions'].append(function)
        data['structs'].append(struct)
        data['enums'].append(enum)
        text = generate.generated(generate.Api(data))
        self.assertIn('extern Status ts_get_crown(SegmentationHandle segmentation, uint tooth, CrownInfo* info);', text)
        self.assertIn('struct CrownInfo', text)
        self.assertIn('enum Side : int', text)
        self.assertIn('"CrownInfo", ', generate.layout(generate.Api(data)))

    def test_a_change_is_seen(self):
        data = description()
        data['structs'][0]['layout']['lp64']['size'] += 8
        with open(os.path.join(HERE, 'Layout.cs'), encoding='utf-8') as file:
            self.assertNotEqual(file.read(), generate.layout(generate.Api(data)))


class Package(unittest.TestCase):
    def test_structure(self):
        with zipfile.ZipFile(PACKAGE) as archive:
            self.assertIsNone(archive.testzip())
            names = set(archive.namelist())
            self.assertEqual(names, {'[Content_Types].xml', '_rels/.rels', 'Toothseg.nuspec', 'lib/netstandard2.0/Toothseg.dll',
                                     'lib/netstandard2.0/Toothseg.xml', 'runtimes/linux-x64/native/libtoothseg.so'})
            types = tree.fromstring(archive.read('[Content_Types].xml'))
            known = {e.get('Extension') for e in types}
            self.assertEqual({n.rsplit('.', 1)[-1] for n in names} - {'xml'}, known - {'xml'})
            target = tree.fromstring(archive.read('_rels/.rels'))[0].get('Target')
            self.assertIn(target.lstrip('/'), names)
            manifest = tree.fromstring(archive.read('Toothseg.nuspec'))
            space = {'n': manifest.tag[1:].split('}')[0]}
            self.assertEqual(manifest.find('n:metadata/n:id', space).text, 'Toothseg')
            self.assertEqual(manifest.find('n:metadata/n:version', space).text, description()['version'])
            self.assertTrue(PACKAGE.endswith('Toothseg.%s.nupkg' % description()['version']))
            self.assertTrue(archive.read('runtimes/linux-x64/native/libtoothseg.so').startswith(b'\x7fELF'))
            library = archive.read('lib/netstandard2.0/Toothseg.dll')
            self.assertTrue(library.startswith(b'MZ'))
            self.assertNotIn(b'ReadOnlySpan', library)  # netstandard2.0 has none

    def test_a_program_runs_with_it(self):
        there = os.path.join(SCRATCH, 'from-package')
        with zipfile.ZipFile(PACKAGE) as archive:
            archive.extractall(there)
        shutil.copy(os.path.join(PROGRAMS, 'hello_tooth.exe'), there)
        shutil.copy(os.path.join(there, 'lib/netstandard2.0/Toothseg.dll'), there)
        environment = dict(os.environ, LD_LIBRARY_PATH=os.path.join(there, 'runtimes/linux-x64/native'))
        result = subprocess.run(['mono', os.path.join(there, 'hello_tooth.exe'), SCAN], env=environment, capture_output=True, text=True,
                                timeout=60)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(len(result.stdout.splitlines()), 50)


class Terminal(unittest.TestCase):
    def test_control_c_cancels(self):
        # Mono hears Ctrl-C where standard input is a terminal.
        labels = os.path.join(SCRATCH, 'cancelled.txt')
        child, terminal = pty.fork()
        if child == 0:
            os.environ['TERM'] = 'xterm'
            os.execvp('mono', ['mono', os.path.join(PROGRAMS, 'segment_arch.exe'), SCAN, '--labels', labels])
        said = b''
        sent = False
        try:
            while True:
                said += os.read(terminal, 4096)
                if b'reading' in said and not sent:
                    sent = True
                    os.write(terminal, b'\x03')
        except OSError:  # the other end is closed
            pass
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        self.assertEqual(status, 2, said)
        self.assertIn(b'TS_E_CANCELLED', said)
        self.assertFalse(os.path.exists(labels))


if __name__ == '__main__':
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules['__main__'])
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    bad = len(result.failures) + len(result.errors)
    print('%d passed, %d failed' % (result.testsRun - bad, bad))
    sys.exit(bad != 0)
