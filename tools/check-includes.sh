#!/bin/sh
# Includes run one way:  check-includes.sh LAMMPS_SRC
#   The C (tm_*.h and *.c of src) includes standard C headers and our own C headers, nothing of LAMMPS or Kokkos.
#   Rooms include rooms below them: TM_CORE, physics, particle (mesh), BACKEND, loops, scene (input, lists,
#   total_lagrangian, smoothing, refinement), diagnostics, style, the top of src.
#   No package includes another one's style, PAIR_SPH_TM none but the C of FIX_ADAPT_NEIGH in its diagnostics, and no
#   header is reached from itself.
set -eu
. "$(dirname -- "$0")/common.sh"

cd "$root"
standard='assert|ctype|errno|float|inttypes|limits|locale|math|stdarg|stdbool|stddef|stdint|stdio|stdlib|string|time'
files=$(find src -name 'tm_*.h' -o -name '*.c' | sort)
bad=$(grep -nE '^[[:space:]]*#[[:space:]]*include' $files /dev/null | grep -vE "<($standard)\.h>" |
  while IFS= read -r line; do
    name=$(echo "$line" | sed -n 's/.*include[[:space:]]*"\([^"]*\)".*/\1/p')
    ours=$(find src -name "${name:-none}")
    # ours in C: named tm_*.h, or the header of one of our .c files
    case $name in tm_*.h) [ -n "$ours" ] && continue ;; esac
    [ -n "$ours" ] && [ -f "${ours%.h}.c" ] && [ ! -f "$1/$name" ] && continue
    echo "$line"
  done)
[ -z "$bad" ] || { echo "$bad"; die "the C may only include standard C and our own C headers"; }

# one line per include of ours: FROM FROM'S PACKAGE, ROOM and LEVEL, then the same of what it includes
find src -name '*.h' -o -name '*.c' -o -name '*.cpp' | sort | xargs grep -HE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' |
  sed 's/:[^"]*"\([^"]*\)".*/ \1/' | awk '
  function place(path,   part, n) {    # sets package, room, level
    n = split(path, part, "/")
    package = n > 2 ? part[2] : ""; room = n > 3 ? part[3] : ""
    level = 8
    if (package == "TM_CORE") level = 0
    else if (package == "BACKEND") level = 3
    else if (package == "HOST") level = 3
    else if (room == "physics") level = 1
    else if (room == "particle" || room == "mesh") level = 2
    else if (room == "loops") level = 4
    else if (room ~ /^(input|scene|lists|total_lagrangian|smoothing|refinement)$/) level = 5
    else if (room == "diagnostics") level = 6
    else if (room == "style") level = 7
  }
  { from[NR] = $1; name[NR] = $2 }
  END {
    while (("find src -type f" | getline path) > 0) {
      base = path; sub(/.*\//, "", base)
      if (base in file) { print "two files are named " base; bad = 1 }
      file[base] = path
    }
    for (k = 1; k <= NR; k++) {
      if (!(name[k] in file)) continue
      to = file[name[k]]
      place(from[k]); p = package; r = room; l = level
      place(to)
      n++
      why = ""
      if (level > l) why = "goes up"
      else if (room == "style" && package != p && l < 8) why = "is of another package'\''s style"
      else if (p == "PAIR_SPH_TM" && package ~ /^(FIX|HEAT)/ && !(r == "diagnostics" && level == 2)) why = "leaves the package"
      if (why != "") { print from[k] " includes " to ": " why; bad = 1 }
      if (from[k] ~ /\.h$/) below[from[k]] = below[from[k]] " " to
    }
    # circles: take away headers that include none of those left
    for (f in below) left[f] = 1
    do {
      changed = 0
      for (f in left) {
        m = split(below[f], list, " "); some = 0
        for (i = 1; i <= m; i++) if (list[i] in left) some = 1
        if (!some) { delete left[f]; changed = 1 }
      }
    } while (changed)
    for (f in left) { print f " is part of a circle of includes, or above one"; bad = 1 }
    if (bad) exit 1
    print n " includes run one way"
  }' || die "includes run one way, and none into another package's style"
echo "$(echo "$files" | wc -l) files include only C"
