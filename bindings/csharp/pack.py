#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""pack.py DLLDIR LIBDIR OUT: lays out the NuGet package in OUT/Toothseg and zips it as OUT/Toothseg.VERSION.nupkg.

DLLDIR has Toothseg.dll and Toothseg.xml as build.sh makes them, without SPAN; LIBDIR has libtoothseg.so.
"""
import json
import os
import shutil
import sys
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))

CONTENT_TYPES = """<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
  <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml" />
  <Default Extension="nuspec" ContentType="application/octet" />
  <Default Extension="dll" ContentType="application/octet" />
  <Default Extension="xml" ContentType="application/octet" />
  <Default Extension="so" ContentType="application/octet" />
</Types>
"""

RELATIONSHIPS = """<?xml version="1.0" encoding="utf-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
  <Relationship Type="http://schemas.microsoft.com/packaging/2010/07/manifest" Target="/Toothseg.nuspec" Id="manifest" />
</Relationships>
"""


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w', encoding='utf-8', newline='\n') as file:
        file.write(text)


def copy(source, path):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    shutil.copyfile(source, path)  # the file itself where the source is a link


def main(dlls, libraries, out):
    with open(os.path.join(HERE, '..', '..', 'abi', 'toothseg.json'), encoding='utf-8') as file:
        version = json.load(file)['version']
    with open(os.path.join(HERE, 'Toothseg.nuspec'), encoding='utf-8') as file:
        manifest = file.read().replace('$version$', version)
    folder = os.path.join(out, 'Toothseg')
    shutil.rmtree(folder, ignore_errors=True)
    write(os.path.join(folder, '[Content_Types].xml'), CONTENT_TYPES)
    write(os.path.join(folder, '_rels', '.rels'), RELATIONSHIPS)
    write(os.path.join(folder, 'Toothseg.nuspec'), manifest)
    for name in ('Toothseg.dll', 'Toothseg.xml'):
        copy(os.path.join(dlls, name), os.path.join(folder, 'lib', 'netstandard2.0', name))
    copy(os.path.join(libraries, 'libtoothseg.so'), os.path.join(folder, 'runtimes', 'linux-x64', 'native', 'libtoothseg.so'))
    package = os.path.join(out, 'Toothseg.%s.nupkg' % version)
    with zipfile.ZipFile(package, 'w', zipfile.ZIP_DEFLATED) as archive:
        for root, folders, files in os.walk(folder):
            folders.sort()
            for name in sorted(files):
                path = os.path.join(root, name)
                archive.write(path, os.path.relpath(path, folder).replace(os.sep, '/'))
    print(package)


if __name__ == '__main__':
    if len(sys.argv) != 4:
        sys.exit('usage: pack.py DLLDIR LIBDIR OUT')
    main(*sys.argv[1:])
