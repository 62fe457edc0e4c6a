#!/bin/sh
# What ./sphtm COMMAND --help prints, for which nothing is built or installed: the help of the command's program.
#   help.sh COMMAND [NAME ...]      fails where a command has none, or where Python lacks what its program imports
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
command=$1
shift

case $command in
  demo) program=examples/high_speed_machining/demo.py ;;
  bench) program=bench/run.py ;;
  effects|many) program=bench/$command.py ;;
  accuracy|stability|validate) program=bench/$command/run.py ;;
  identify) program=bench/validate/identify.py ;;
  scenes)
    program=examples/${1:-}/scene.py
    if [ ! -f "$root/$program" ]; then
      echo "scenes:$(cd "$root/examples" && printf ' %s' */scene.py | sed 's,/scene.py,,g'); options of each: ./sphtm scenes NAME --help"
      exit 0
    fi ;;
  *) exit 1 ;;
esac
[ -f "$root/$program" ] || exit 1
help=$(PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$root/$program" --help 2> /dev/null) || exit 1
printf '%s\n' "$help"
