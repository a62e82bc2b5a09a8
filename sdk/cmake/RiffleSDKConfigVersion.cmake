# The SDK's version is that of the boundary, which abi.h alone says. From 1.0 on, a newer minor serves projects written
# for an older one; below, nothing is promised from one minor to the next, so it must be the very same.
include("${CMAKE_CURRENT_LIST_DIR}/RiffleSDKRoot.cmake")
if(_riffle_root)
  file(STRINGS "${_riffle_root}/include/riffle/abi.h" _riffle_lines REGEX "^#define RIFFLE_ABI_M(AJOR|INOR) ")
  if(_riffle_lines MATCHES "MAJOR ([0-9]+).*MINOR ([0-9]+)")
    set(PACKAGE_VERSION "${CMAKE_MATCH_1}.${CMAKE_MATCH_2}")
    if(PACKAGE_FIND_VERSION_MAJOR EQUAL CMAKE_MATCH_1 AND PACKAGE_FIND_VERSION VERSION_LESS_EQUAL PACKAGE_VERSION
        AND (CMAKE_MATCH_1 GREATER 0 OR PACKAGE_FIND_VERSION_MINOR EQUAL CMAKE_MATCH_2))
      set(PACKAGE_VERSION_COMPATIBLE TRUE)
    endif()
  endif()
  if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
    set(PACKAGE_VERSION_EXACT TRUE)
  endif()
endif()
