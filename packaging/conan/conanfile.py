# SPDX-License-Identifier: Apache-2.0
"""conan create packaging/conan: builds the tree that this recipe lies in. For Conan 2."""
import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir

required_conan_version = ">=2.0"


class ToothsegConan(ConanFile):
    name = "toothseg"
    description = "Separates the teeth of a scanned dental arch, one click a pair, behind a C ABI"
    license = "Apache-2.0"
    topics = ("dental", "mesh", "segmentation")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": True, "fPIC": True}
    implements = ["auto_shared_fpic"]

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, os.pardir, os.pardir)

    def set_version(self):
        text = load(self, os.path.join(self._root, "CMakeLists.txt"))
        self.version = re.search(r"project\(toothseg VERSION ([0-9.]+)", text).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "THIRD_PARTY.md", "cmake/*", "include/*", "src/*", "synth/*"):
            copy(self, pattern, src=self._root, dst=self.export_sources_folder)

    def validate(self):
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration("toothseg is built on Linux")
        check_min_cppstd(self, 20)

    def requirements(self):
        self.requires("eigen/3.4.0")
        self.requires("nlohmann_json/[>=3.10 <4]")
        self.requires("onetbb/[>=2021.8 <2023]")

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25]")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["TOOTHSEG_BUILD_SHARED"] = bool(self.options.shared)
        toolchain.cache_variables["TOOTHSEG_BUILD_STATIC"] = not self.options.shared
        toolchain.cache_variables["TOOTHSEG_BUILD_TESTS"] = False
        toolchain.cache_variables["TOOTHSEG_BUILD_BENCH"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        for file in ("LICENSE", "THIRD_PARTY.md"):
            copy(self, file, src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        # Conan writes its own for each consumer.
        for folder in ("cmake", "pkgconfig"):
            rmdir(self, os.path.join(self.package_folder, "lib", folder))
        rmdir(self, os.path.join(self.package_folder, "share"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "toothseg")
        self.cpp_info.set_property("cmake_target_name", "toothseg::toothseg")

        library = self.cpp_info.components["libtoothseg"]
        library.set_property("cmake_target_name", "toothseg::toothseg")
        library.set_property("pkg_config_name", "toothseg")
        library.libs = ["toothseg"]
        library.requires = ["eigen::eigen", "nlohmann_json::nlohmann_json", "onetbb::libtbb"]
        if not self.options.shared:
            library.set_property("cmake_target_aliases", ["toothseg::static"])
            library.defines = ["TS_STATIC"]
            library.system_libs = ["stdc++", "m"]

        arch = self.cpp_info.components["arch"]
        arch.set_property("cmake_target_name", "toothseg::arch")
        arch.libs = ["toothseg_arch"]
        arch.system_libs = ["stdc++", "m"]
