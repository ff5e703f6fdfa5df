# SPDX-License-Identifier: Apache-2.0
# An overlay port: it builds the tree that it lies in.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" dynamic SHARED)
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" static STATIC)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DTOOTHSEG_BUILD_SHARED=${SHARED}
    -DTOOTHSEG_BUILD_STATIC=${STATIC}
    -DTOOTHSEG_BUILD_TESTS=OFF
    -DTOOTHSEG_BUILD_BENCH=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/toothseg)
vcpkg_fixup_pkgconfig()

# vcpkg has one copy of the headers, and the licences in share/toothseg.
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
  "${CURRENT_PACKAGES_DIR}/share/doc")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/THIRD_PARTY.md")
