# find_package(RiffleSDK) gives the target Riffle::sdk and the function
#   riffle_add_plugin(name file.cpp ...)
# which builds a plugin library with the flags that keep it fast (loops over pairs vectorise) and safe (one exported
# symbol, floating-point environment untouched: never -ffast-math). C and C++ sources, GCC and Clang. Where the program
# is installed beside the SDK and the project has called enable_testing(), `ctest` runs `riffle check` on the plugin.
cmake_minimum_required(VERSION 3.22)

option(RIFFLE_PLUGIN_NATIVE "Build plugins for the vector width of this machine" ON)

include("${CMAKE_CURRENT_LIST_DIR}/RiffleSDKRoot.cmake")
if(NOT _riffle_root)
  set(RiffleSDK_FOUND FALSE)
  set(RiffleSDK_NOT_FOUND_MESSAGE "include/riffle/abi.h stands in no folder above ${CMAKE_CURRENT_LIST_DIR}")
  return()
endif()

if(NOT TARGET Riffle::sdk)
  add_library(riffle_sdk INTERFACE)
  add_library(Riffle::sdk ALIAS riffle_sdk)
  target_include_directories(riffle_sdk SYSTEM INTERFACE "${_riffle_root}/include")
  set_property(GLOBAL PROPERTY RIFFLE_SDK_ROOT "${_riffle_root}")
endif()

# All options that reach the compiler or linker of the plugin, from wherever they were set.
function(_riffle_options name result)
  get_target_property(sources ${name} SOURCES)
  get_target_property(libraries ${name} LINK_LIBRARIES)
  set(options "")
  foreach(flags C_FLAGS CXX_FLAGS MODULE_LINKER_FLAGS)
    list(APPEND options "${CMAKE_${flags}}")
    foreach(config ${CMAKE_BUILD_TYPE} ${CMAKE_CONFIGURATION_TYPES})
      string(TOUPPER "${config}" config)
      list(APPEND options "${CMAKE_${flags}_${config}}")
    endforeach()
  endforeach()
  foreach(property COMPILE_OPTIONS COMPILE_FLAGS LINK_OPTIONS LINK_FLAGS)
    get_property(value TARGET ${name} PROPERTY ${property})
    list(APPEND options ${value})
    foreach(library ${libraries})
      if(TARGET ${library})
        get_property(value TARGET ${library} PROPERTY INTERFACE_${property})
        list(APPEND options ${value})
      endif()
    endforeach()
    foreach(source ${sources})
      get_property(value SOURCE "${source}" PROPERTY ${property})
      list(APPEND options ${value})
    endforeach()
  endforeach()
  set(${result} "${options}" PARENT_SCOPE)
endfunction()

function(_riffle_refuse_fast_math name)
  _riffle_options(${name} options)
  if(options MATCHES "-(ffast-math|Ofast|funsafe-math-optimizations|ffinite-math-only|mdaz-ftz)")
    message(FATAL_ERROR "riffle_add_plugin(${name}): ${CMAKE_MATCH_0} is refused, because such a library changes the "
      "floating-point state of the whole program when it is loaded, or hides NaN. Loops vectorise without it: "
      "-fno-math-errno and -fno-trapping-math are set already.")
  endif()
endfunction()

function(riffle_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE Riffle::sdk)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" C_VISIBILITY_PRESET hidden
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if("C" IN_LIST languages)
    target_compile_features(${name} PRIVATE c_std_11)
  endif()
  if("CXX" IN_LIST languages)
    target_compile_features(${name} PRIVATE cxx_std_17)
  endif()
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -fopenmp-simd -fno-math-errno -fno-trapping-math
    $<$<NOT:$<CONFIG:Debug>>:-O3>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>
    $<$<BOOL:${RIFFLE_PLUGIN_NATIVE}>:-march=native>)
  if(NOT APPLE)
    target_link_options(${name} PRIVATE
      "-Wl,--version-script=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/plugin.map")
    _riffle_options(${name} options)
    if(NOT options MATCHES "-fsanitize") # a sanitizer's run-time is resolved by the program
      target_link_options(${name} PRIVATE -Wl,-z,defs)
    endif()
  endif()
  # Once more when the directory is read to its end, because options may be added after this call.
  _riffle_refuse_fast_math(${name})
  cmake_language(EVAL CODE "cmake_language(DEFER CALL _riffle_refuse_fast_math [[${name}]])")

  get_property(root GLOBAL PROPERTY RIFFLE_SDK_ROOT)
  if(EXISTS "${root}/bin/riffle")
    add_test(NAME check.${name} COMMAND "${root}/bin/riffle" check $<TARGET_FILE:${name}>)
  endif()
endfunction()
