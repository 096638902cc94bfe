# Eigen, LCM and yaml-cpp: those of CMAKE_PREFIX_PATH or of the python3 that is active, else the
# system's, else fetched. The wheels `lcm`, `cmeel-eigen` and `cmeel-yaml-cpp` carry headers,
# libraries and CMake files.

# Asks python3 where its packages are; silent where there is no Python or nothing of ours in it.
function(pilotage_add_pip_prefixes)
  if(NOT Python_EXECUTABLE)
    set(Python_EXECUTABLE python3)
  endif()
  execute_process(
    COMMAND ${Python_EXECUTABLE} -c "import sys; print(';'.join(p for p in sys.path if p))"
    OUTPUT_VARIABLE paths OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(failed)
    return()
  endif()
  foreach(path IN LISTS paths)
    foreach(prefix "${path}" "${path}/cmeel.prefix" "${path}/pybind11")
      file(GLOB configs "${prefix}/lib/lcm/cmake" "${prefix}/lib/cmake/yaml-cpp"
                        "${prefix}/share/eigen3/cmake" "${prefix}/share/cmake/pybind11")
      if(configs)
        list(APPEND CMAKE_PREFIX_PATH "${prefix}")
      endif()
    endforeach()
  endforeach()
  set(CMAKE_PREFIX_PATH "${CMAKE_PREFIX_PATH}" PARENT_SCOPE)
endfunction()

# Fetches and adds a dependency that find_package did not find.
#   pilotage_fetch(<name> <url> <sha256> <how to install it instead>)
# A macro, so that options set before it hold in the fetched project.
macro(pilotage_fetch name url sha256 advice)
  include(FetchContent)
  string(TOUPPER "${name}" _upper)
  set(_source "${url}")
  if(NOT FETCHCONTENT_SOURCE_DIR_${_upper})
    # Downloaded here and not by FetchContent, to be able to say what to do where it fails.
    set(_source "${PROJECT_BINARY_DIR}/_deps/${name}.tar.gz")
    if(NOT EXISTS "${_source}")
      message(STATUS "${name} was not found, fetching ${url}")
      file(DOWNLOAD "${url}" "${_source}" STATUS _status TLS_VERIFY ON TIMEOUT 300)
      if(NOT _status MATCHES "^0;")
        file(REMOVE "${_source}")
        message(FATAL_ERROR "Pilotage needs ${name}: CMake did not find it, and fetching ${url} "
                            "failed (${_status}).\nInstall it: ${advice}")
      endif()
    endif()
  endif()
  FetchContent_Declare(${name} URL "${_source}" URL_HASH SHA256=${sha256})
  FetchContent_MakeAvailable(${name})
endmacro()

pilotage_add_pip_prefixes()
set(CMAKE_POLICY_VERSION_MINIMUM 3.5)  # yaml-cpp 0.8 asks for less than CMake 4 grants
set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)  # options of fetched projects are set by plain variables
set(BUILD_TESTING OFF)                 # their tests are not ours

find_package(Eigen3 3.4 CONFIG QUIET)
if(NOT Eigen3_FOUND)
  set(EIGEN_BUILD_DOC OFF)
  set(EIGEN_BUILD_PKGCONFIG OFF)
  pilotage_fetch(Eigen3 https://gitlab.com/libeigen/eigen/-/archive/3.4.0/eigen-3.4.0.tar.gz
    8586084f71f9bde545ee7fa6d00288b264a2b7ac3607b974e54d13e7162c1c72
    "pip install cmeel-eigen, or sudo apt install libeigen3-dev")
endif()

find_package(yaml-cpp CONFIG QUIET)
if(NOT yaml-cpp_FOUND)
  set(YAML_CPP_BUILD_TESTS OFF)
  set(YAML_CPP_BUILD_TOOLS OFF)
  set(YAML_CPP_INSTALL ON)
  pilotage_fetch(yaml-cpp https://github.com/jbeder/yaml-cpp/archive/refs/tags/0.8.0.tar.gz
    fbe74bbdcee21d656715688706da3c8becfd946d92cd44705cc6098bb23b3a16
    "pip install 'cmeel-yaml-cpp==0.8.*', or sudo apt install libyaml-cpp-dev")
endif()
set(PILOTAGE_YAML_CPP yaml-cpp::yaml-cpp)
if(NOT TARGET yaml-cpp::yaml-cpp)  # before 0.8 the target had no namespace
  set(PILOTAGE_YAML_CPP yaml-cpp)
endif()

find_package(lcm 1.5 CONFIG QUIET)
if(NOT lcm_FOUND)
  foreach(part JAVA PYTHON LUA GO TESTS EXAMPLES)
    set(LCM_ENABLE_${part} OFF)
  endforeach()
  pilotage_fetch(lcm https://github.com/lcm-proj/lcm/archive/refs/tags/v1.5.2.tar.gz
    d443261619080f1c0693237b2019436988e1b2b2ba5fc09a49bf23769e1796de
    "pip install 'lcm>=1.5.3'; building it from source needs libglib2.0-dev")
  set(LCM_USE_FILE "${lcm_SOURCE_DIR}/lcm-cmake/lcmUtilities.cmake")
endif()
include("${LCM_USE_FILE}")

# LCM's wheel needs the system's GLib: better said here than by the loader in the midst of the build.
get_target_property(lcm_gen lcm-gen IMPORTED_LOCATION_RELEASE)
if(lcm_gen)
  execute_process(COMMAND "${lcm_gen}" --version
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE error)
  if(failed)
    message(FATAL_ERROR "lcm-gen does not run: ${error}"
                        "If libglib-2.0.so.0 is what is missing: sudo apt install libglib2.0-0")
  endif()
endif()

foreach(package Eigen3 yaml-cpp lcm)
  if(${package}_FOUND)
    message(STATUS "Found ${package} ${${package}_VERSION}: ${${package}_DIR}")
  endif()
endforeach()
