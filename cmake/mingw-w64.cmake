# SPDX-License-Identifier: Apache-2.0
# 64-bit Windows by Debian's MinGW-w64, in the kind with POSIX threads: what std::thread of its C++ library needs.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(triplet x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${triplet}-gcc-posix)
set(CMAKE_CXX_COMPILER ${triplet}-g++-posix)
set(CMAKE_RC_COMPILER ${triplet}-windres)
set(CMAKE_DLLTOOL ${triplet}-dlltool)

# Programs are this machine's; libraries and headers are Windows', or where a package is named by its ..._DIR.
set(CMAKE_FIND_ROOT_PATH /usr/${triplet})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)

# A program or DLL carries GCC's runtime and the threads of MinGW-w64 in it: there is no place on Windows where they would be found.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-static")

# Where Wine is, tests run by it: add_test begins with this.
find_program(TOOTHSEG_WINE NAMES wine64 wine wine64-stable wine-stable NO_CMAKE_FIND_ROOT_PATH)
if(TOOTHSEG_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${TOOTHSEG_WINE})
endif()
