#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every function that the C# binding calls is exported by toothseg.dll, and it calls each that is. Fails where not."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
source = (root / "bindings/csharp/Toothseg/Generated.cs").read_text(encoding="utf-8")
exported = set(re.findall(r"^  (ts_\w+) @", (root / "abi/toothseg.def").read_text(encoding="utf-8"), re.M))
called = set(re.findall(r"extern [^;(]*?\b(ts_\w+)\(", source))
library = re.search(r'const string Library = "([^"]+)"', source)
print(f"{len(called)} called of {len(exported)}; library {library and library.group(1)}")
sys.exit(called != exported or not called or not library or library.group(1) not in ("toothseg", "toothseg.dll"))
