# find_package(RiffleSDK) gives the target Riffle::sdk and the function
#   riffle_add_plugin(name file.cpp ...)
# which builds a plugin library with the flags that keep it fast (loops over pairs vectorise) and safe (one exported
# symbol, floating-point environment untouched: never -ffast-math).
if(NOT TARGET Riffle::sdk)
  add_library(riffle_sdk INTERFACE)
  add_library(Riffle::sdk ALIAS riffle_sdk)
  if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/../include/riffle/abi.h") # in the source tree
    get_filename_component(_riffle_include "${CMAKE_CURRENT_LIST_DIR}/../include" ABSOLUTE)
  else() # installed: <prefix>/<lib>/cmake/RiffleSDK, possibly <prefix>/lib/<triplet>/cmake/RiffleSDK
    find_path(_riffle_include riffle/abi.h
      HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../include" "${CMAKE_CURRENT_LIST_DIR}/../../../../include" REQUIRED)
  endif()
  target_include_directories(riffle_sdk SYSTEM INTERFACE "${_riffle_include}")
  target_compile_features(riffle_sdk INTERFACE cxx_std_17)
endif()

set(RIFFLE_SDK_DIR "${CMAKE_CURRENT_LIST_DIR}" CACHE INTERNAL "where plugin.map is")
option(RIFFLE_PLUGIN_NATIVE "Build plugins for the vector width of this machine" ON)

function(riffle_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE Riffle::sdk)
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" C_VISIBILITY_PRESET hidden
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -fopenmp-simd -fno-math-errno -fno-trapping-math
    $<$<CONFIG:Release,RelWithDebInfo,>:-O3>
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:-fno-gnu-unique>
    $<$<BOOL:${RIFFLE_PLUGIN_NATIVE}>:-march=native>)
  if(NOT APPLE)
    target_link_options(${name} PRIVATE "-Wl,--version-script=${RIFFLE_SDK_DIR}/plugin.map")
    if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize") # a sanitizer's run-time is resolved by the host
      target_link_options(${name} PRIVATE -Wl,-z,defs)
    endif()
  endif()
endfunction()
