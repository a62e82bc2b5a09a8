#!/usr/bin/env bash
# The three walls: host/ includes nothing of plugins/; plugins/ include only the SDK, the standard library and Eigen; sdk/
# includes nothing of the two. And the boundary itself is plain C: no C++ type, no Eigen in abi.h and fields.h.
set -u
cd "$1" || exit 1
broken=0

forbid() { # sentence, pattern, place...
  local sentence=$1 pattern=$2 found
  shift 2
  if found=$(grep -rnE --include='*.[ch]' --include='*.[ch]pp' "$pattern" "$@"); then
    printf '%s:\n%s\n' "$sentence" "$found"
    broken=1
  fi
}

include='^[[:space:]]*#[[:space:]]*include[[:space:]]*["<]'
up='(\.\./)*'
forbid "host/ includes a plugin" \
  "$include$up(plugins/(kernels|equations|viscosity|drag|turbulence|boundaries|filters|references)|kernels|equations)/" host
forbid "the SDK includes the host or a plugin" "$include$up(host|plugins)/" sdk
forbid "the SDK includes a library that a plugin's author would have to install" \
  "$include(boost|fmt|spdlog|toml|CLI|hdf5|H5|nlohmann|muParser|Eigen|gtest|benchmark)" sdk
forbid "the boundary is plain C" '(std|Eigen)::|^ *(template|namespace|class|using) ' \
  sdk/include/riffle/abi.h sdk/include/riffle/fields.h

# Standard headers have no slash: <cmath>, <stdint.h>. A header in quotes without a folder is the plugin's own neighbour.
allowed='<riffle/|"riffle/|<Eigen/|<[a-z0-9_]+(\.h)?>|"[a-z0-9_-]+\.(h|hpp)"'
others='<(omp|hdf5|H5public|gsl|mpi)\.h>'
if found=$(grep -rnE --include='*.[ch]' --include='*.[ch]pp' "$include" plugins | grep -vE "include *($allowed)|$others\$") ||
  found=$(grep -rnE --include='*.[ch]' --include='*.[ch]pp' "include *$others" plugins); then
  printf 'a plugin includes more than the SDK, the standard library and Eigen:\n%s\n' "$found"
  broken=1
fi
exit $broken
