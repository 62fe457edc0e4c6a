"""What a summary needs so that its numbers can be made again: the command, the commit and the date.

Commit: SPHTM_COMMIT, where it is set; in a bundle the one it was built from (file version); else that of the folder's git, with + where
files have been changed since."""
import datetime
import os
import shlex
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def git(*arguments):
    try:
        return subprocess.run(["git", "-C", ROOT, *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def commit():
    built = os.path.join(ROOT, "version")
    if not os.environ.get("SPHTM_COMMIT") and os.path.isfile(built):
        with open(built) as f:
            return f.read().strip()
    head = git("rev-parse", "--short=7", "HEAD")
    changed = git("status", "--porcelain", "--untracked-files=no", "--", "src", "examples", "materials", "bench")
    return os.environ.get("SPHTM_COMMIT") or (head + ("+" if changed else "") if head else "unknown")


def provenance(command=None):
    if command is None:
        name = os.path.relpath(os.path.abspath(sys.argv[0]), ROOT)
        command = shlex.join([name] + sys.argv[1:])
    return {"command": command, "commit": commit(), "date": datetime.date.today().isoformat()}
