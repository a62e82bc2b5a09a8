# _riffle_root: the folder above this file whose include/ holds the headers: sdk/ in the source tree, the prefix once
# installed. Empty when there is none.
get_filename_component(_riffle_root "${CMAKE_CURRENT_LIST_DIR}" REALPATH)
while(_riffle_root AND NOT EXISTS "${_riffle_root}/include/riffle/abi.h")
  get_filename_component(_riffle_above "${_riffle_root}" DIRECTORY)
  if(_riffle_above STREQUAL _riffle_root)
    set(_riffle_above "")
  endif()
  set(_riffle_root "${_riffle_above}")
endwhile()
