"""./sphtm COMMAND --help prints the command and its options, and builds, downloads and installs nothing."""
import os
import re

from driver_case import SOURCE, Case, end, say

c = Case()
usage, status = c.sphtm("help")
commands = re.findall(r"^  ([a-z-]+) ", usage, re.M)
say(status == 0 and len(commands) > 15, "help lists the commands", usage)

# what would install, download, build or run says so
for name in "apt-get", "cmake", "ninja", "ctest", "sphinx-build":
    c.stub(name, "echo called >> '%s'; exit 1" % os.path.join(c.top, "called").replace("'", "'\\''"))
for command in commands:
    if command in ("lmp", "results", "help"):
        continue
    for words in ([command, "--help"], [command, "name", "-h"]):
        out, status = c.sphtm(*words)
        say(status == 0 and out.startswith("  %s " % command), "help of %s" % " ".join(words), out)
say(not os.path.exists(os.path.join(c.top, "called")), "nothing was called for it")
say(not os.path.exists(c.cache) or not os.listdir(c.cache), "the cache is empty")
say(not os.path.exists(os.path.join(c.checkout, "--help")), "no folder is called --help")
out, status = c.sphtm("validat", "--help")
say(status == 2 and "no command 'validat'" in out, "an unknown command has no help", out)


def whole(*words):
    return c.run("sh", "-c", 'cd "$0" && exec ./sphtm "$@"', SOURCE, *words)


# in the whole checkout: the options of the programs
for command, option in (("validate", "--quick"), ("accuracy", "--size"), ("many", "--vary"), ("demo", "--spacing"), ("effects", "--counted"),
                        ("bench", "--rounds"), ("stability", "--cases"), ("identify", "--fit")):
    out, status = whole(command, "--help")
    say(status == 0 and option in out, "%s --help has its options" % command, out)
out, status = whole("scenes", "taylor_bar", "--help")
say(status == 0 and "--size" in out, "scenes taylor_bar --help has its options", out)
out, status = whole("scenes", "--help")
say(status == 0 and "taylor_bar" in out, "scenes --help names the scenes", out)
end()
