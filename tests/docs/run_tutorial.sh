#!/usr/bin/env bash
# Does what a page tells its reader to do: run_tutorial.sh PAGE PREFIX [FIGURE]. Blocks marked `console` hold commands, each on a
# line that begins with "$ "; a block with a file name after its language, such as `cpp my-drag/my-drag.cpp`, becomes that
# file. Both are taken in the order of the page, in an empty folder, with the Riffle that is installed under PREFIX. Every
# command must succeed, every run end well, and a figure must come out, which is kept as FIGURE when that is given.
set -euo pipefail
page=$(readlink -f "$1")
prefix=$(readlink -f "$2")
keep=${3:+$(readlink -f "$3")}
[ -x "$prefix/bin/riffle" ] || { echo "no riffle is installed under $prefix"; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export PATH=$prefix/bin:$PATH CMAKE_PREFIX_PATH=$prefix
unset RIFFLE_PLUGIN_PATH

awk '
  BEGIN { print "set -euo pipefail" }
  /^```/ && inside != "" { if (inside == "file") print "END OF THE FILE"; inside = ""; next }
  /^```console *$/ { inside = "console"; next }
  /^```[a-z]+ +[^ ]+ *$/ { inside = "file"; print "cat >\"" $2 "\" <<\"END OF THE FILE\""; next }
  /^```/ { inside = "other"; next }
  inside == "file" { print }
  inside == "console" {
    if ($0 !~ /^\$ /) { print "line " NR ": a console block holds commands alone, got: " $0 >"/dev/stderr"; exit 1 }
    command = substr($0, 3)
    shown = command
    gsub(/[\\"$`]/, "\\\\&", shown)
    print "echo \"$ " shown "\"\n" command
    ++commands
  }
  END { if (commands == 0) { print "the page has no commands" >"/dev/stderr"; exit 1 } }
' "$page" >"$folder/.commands"
bash "$folder/.commands"

records=$(find . -name run.json)
[ -n "$records" ] || { echo "no command of the page has left a run"; exit 1; }
# shellcheck disable=SC2086 # a list of files without spaces
if grep -L '"status": "finished"' $records | grep .; then
  echo "these runs did not finish"
  exit 1
fi
figure=$(grep -o '[a-z-]*\.png"' "$folder"/*.gp | tr -d '"' | cut -d: -f2)
[ -s "$folder/$figure" ] || { echo "no figure $figure came out"; exit 1; }
if [ -n "$keep" ]; then cp "$folder/$figure" "$keep"; fi
