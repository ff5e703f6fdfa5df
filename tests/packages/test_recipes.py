#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""test_recipes.py BUILD: the recipes for vcpkg and Conan, as far as they go without either. The vcpkg port runs to its end,
with stand-ins for vcpkg's functions and for the compiler (it gives the objects of BUILD), and what it installs is used. The
Conan recipe runs with stand-ins for Conan's classes."""
import collections
import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import types

sys.dont_write_bytecode = True  # the recipes lie in the source tree
ROOT = pathlib.Path(__file__).resolve().parents[2]
PORT = ROOT / "packaging/vcpkg/toothseg"
CONAN = ROOT / "packaging/conan"


def run(*command):
    done = subprocess.run([str(c) for c in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}:\n{done.stdout}")
    return done.stdout


def project():
    """Version, options, and the packages that the library wants, as the project's own CMake files have them."""
    top = (ROOT / "CMakeLists.txt").read_text()
    # Neither what tests need, nor CMake's own.
    others = {"doctest", "OpenMesh", "Threads"}
    wanted = {name for file in ("CMakeLists.txt", "src/api/CMakeLists.txt")
              for name in re.findall(r"^ *find_package\((\w+)", (ROOT / file).read_text(), re.M)} - others
    return re.search(r"VERSION ([0-9.]+) LANG", top).group(1), set(re.findall(r"^option\((\w+)", top, re.M)), wanted


def manifest(version, wanted):
    port = json.loads((PORT / "vcpkg.json").read_text())
    assert (port["name"], port["version"], port["license"]) == ("toothseg", version, "Apache-2.0")
    named = {d if isinstance(d, str) else d["name"] for d in port["dependencies"]}
    assert named == {n.lower().replace("_", "-") for n in wanted} | {"vcpkg-cmake", "vcpkg-cmake-config"}, named


STAND_INS = """
set(ENV{CMAKE_BUILD_PARALLEL_LEVEL} 1)
function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" SOURCE_PATH OPTIONS)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER_LAUNCHER=${WORK}/compiler.sh -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR} ${arg_OPTIONS} ${OBJECTS}
    ERROR_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  if(said MATCHES "not used by the project")
    message(FATAL_ERROR "${said}")
  endif()
endfunction()
function(vcpkg_cmake_install)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target install OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" CONFIG_PATH "")
  file(RENAME ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH} ${CURRENT_PACKAGES_DIR}/share/toothseg)
  file(GLOB configs ${CURRENT_PACKAGES_DIR}/share/toothseg/*.cmake)
  foreach(config ${configs})  # vcpkg's own does more: here only the depth below the prefix changes
    file(READ ${config} text)
    string(REPLACE "/../../../" "/../../" text "${text}")
    string(REPLACE [[get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)]]
      [[set(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_DIR}/x")]] text "${text}")
    file(WRITE ${config} "${text}")
  endforeach()
endfunction()
function(vcpkg_fixup_pkgconfig)
  file(READ ${CURRENT_PACKAGES_DIR}/lib/pkgconfig/toothseg.pc text)
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" FILE_LIST)
  file(INSTALL ${arg_FILE_LIST} DESTINATION ${CURRENT_PACKAGES_DIR}/share/${PORT})
endfunction()
"""

# Gives the object of the same name in BUILD; the link is the linker's own.
COMPILER = """#!/bin/sh
while [ $# -gt 0 ]; do
  case $1 in -o) object=$2 ;; -MF) dependencies=$2 ;; esac
  shift
done
cp "{build}/$object" "$object" && echo "$object:" >"$dependencies"
"""


def port(build, linkage):
    work = build / f"packages-test/vcpkg_{linkage}"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    packages = work / "packages"
    compiler = work / "compiler.sh"
    compiler.write_text(COMPILER.format(build=build))
    compiler.chmod(0o755)
    # How many files an object is made of, as in BUILD.
    objects = re.findall(r"^(CMAKE_UNITY_BUILD\w*):\w+=(.+)$", (build / "CMakeCache.txt").read_text(), re.M)
    sets = {"OBJECTS": ";".join(f"-D{name}={value}" for name, value in objects), "WORK": work, "PORT": "toothseg", "CURRENT_PACKAGES_DIR": packages, "VCPKG_LIBRARY_LINKAGE": linkage}
    text = "".join(f'set({k} "{v}")\n' for k, v in sets.items()) + STAND_INS + f'include("{PORT}/portfile.cmake")\n'
    (work / "run.cmake").write_text(text)
    run("cmake", "-P", work / "run.cmake")
    have = {str(p.relative_to(packages)) for p in packages.rglob("*") if p.is_file()}
    library, other = ("lib/libtoothseg.a", "lib/libtoothseg.so")[::1 if linkage == "static" else -1]
    for file in (library, "lib/libtoothseg_arch.a", "include/toothseg.h", "include/toothseg.hpp",
                 "include/toothseg/base.hpp", "share/toothseg/toothsegConfig.cmake", "share/toothseg/usage",
                 "share/toothseg/LICENSE", "share/toothseg/THIRD_PARTY.md", "lib/pkgconfig/toothseg.pc"):
        assert file in have, f"no {file}"
    assert other not in have and not any(f.startswith("share/doc") for f in have), have

    # One library alone, by its plain name.
    consumer = work / "consumer"
    consumer.mkdir()
    (consumer / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.16)\nproject(consumer LANGUAGES C CXX)\nfind_package(toothseg CONFIG REQUIRED)\n"
        f"add_executable(main {ROOT}/tests/packages/consumer/count_labels.c)\n"
        "target_link_libraries(main PRIVATE toothseg::toothseg toothseg::arch)\n")
    run("cmake", "-S", consumer, "-B", consumer / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={packages}")
    run("cmake", "--build", consumer / "build")
    said = run(consumer / "build/main")
    assert re.match(r"\d+ labels on", said), said


class Settable:
    """Stands for Conan's objects with properties."""

    def __init__(self):
        self.properties, self.components, self.cache_variables = {}, collections.defaultdict(Settable), {}

    def set_property(self, key, value):
        self.properties[key] = value


def stand_in_for_conan(toolchains, copied):
    def toolchain(_recipe):
        toolchains.append(Settable())
        toolchains[-1].generate = lambda: None
        return toolchains[-1]

    class Recipe:
        recipe_folder = str(CONAN)
        export_sources_folder = "exported"

        def __init__(self):
            self.required, self.cpp_info, self.options = [], Settable(), types.SimpleNamespace(shared=True)
            self.settings = types.SimpleNamespace(os="Linux")

        def requires(self, reference):
            self.required.append(reference)

    def copy(_recipe, pattern, src, dst):
        copied.extend(pathlib.Path(src).glob(pattern))
        assert dst == "exported"

    def module(name, **members):
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)

    def generates(_recipe):
        return types.SimpleNamespace(generate=lambda: None)

    module("conan", ConanFile=Recipe)
    module("conan.errors", ConanInvalidConfiguration=type("Invalid", (Exception,), {}))
    module("conan.tools")
    module("conan.tools.build", check_min_cppstd=lambda _recipe, _standard: None, can_run=lambda _recipe: True)
    module("conan.tools.cmake", CMake=None, CMakeDeps=generates, CMakeToolchain=toolchain, cmake_layout=lambda _recipe: None)
    module("conan.tools.files", copy=copy, load=lambda _recipe, path: pathlib.Path(path).read_text(), rmdir=None)


def load(path):
    spec = importlib.util.spec_from_file_location(path.parent.name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def conan(version, options, wanted):
    toolchains, copied = [], []
    stand_in_for_conan(toolchains, copied)
    load(CONAN / "test_package/conanfile.py")
    recipe_class = load(CONAN / "conanfile.py").ToothsegConan
    for shared in (True, False):
        recipe = recipe_class()
        recipe.options.shared = shared
        recipe.set_version()
        assert recipe.version == version
        recipe.validate()
        recipe.requirements()
        assert {r.split("/")[0] for r in recipe.required} == {"eigen", "nlohmann_json", "onetbb"} and len(wanted) == 3
        recipe.generate()
        given = toolchains[-1].cache_variables
        assert set(given) <= options, f"the project has no option {set(given) - options}"
        assert (given["TOOTHSEG_BUILD_SHARED"], given["TOOTHSEG_BUILD_STATIC"]) == (shared, not shared)
        recipe.package_info()
        targets = {c.properties["cmake_target_name"] for c in recipe.cpp_info.components.values()}
        assert targets == {"toothseg::toothseg", "toothseg::arch"}
    recipe.export_sources()
    for file in ("CMakeLists.txt", "LICENSE", "THIRD_PARTY.md", "include/toothseg.h", "cmake/toothseg.pc.in",
                 "cmake/toothsegInstall.cmake", "src/CMakeLists.txt", "synth/CMakeLists.txt"):
        assert (CONAN / "../.." / file) in copied, f"{file} is not exported"


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    version, options, wanted = project()
    manifest(version, wanted)
    conan(version, options, wanted)
    for linkage in ("static", "dynamic"):
        port(build, linkage)


if __name__ == "__main__":
    main()
