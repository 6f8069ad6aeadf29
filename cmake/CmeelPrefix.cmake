# SPDX-License-Identifier: BSD-3-Clause
# The pip wheels of Pinocchio and ProxSuite are in site-packages/cmeel.prefix, which CMake does not
# search. Get its path from cmeel and put it first, so that no system Eigen is found before it. With
# Pinocchio from conda or from the system there is no cmeel, and nothing changes.
if(NOT Python_EXECUTABLE)
  find_package(Python COMPONENTS Interpreter QUIET)
endif()
if(Python_EXECUTABLE)
  execute_process(
    COMMAND ${Python_EXECUTABLE} -m cmeel cmake
    OUTPUT_VARIABLE _cmeel_prefixes
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET)
  if(_cmeel_prefixes)
    string(REPLACE ":" ";" _cmeel_prefixes "${_cmeel_prefixes}")
    list(REMOVE_DUPLICATES _cmeel_prefixes)
    list(PREPEND CMAKE_PREFIX_PATH ${_cmeel_prefixes})
  endif()
endif()
