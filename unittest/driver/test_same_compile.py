"""tools/same-compile.py takes what another build has compiled with the same command and headers, and compiles everything else."""
import json
import os
import subprocess
import sys
import tempfile

TOOL = os.path.join(os.environ["SPHTM_SOURCE"], "tools", "same-compile.py")
failed = 0


def expect(what, found, wanted):
    global failed
    failed += found != wanted
    print("%-5s %s: %s" % ("ok" if found == wanted else "FAIL", what, found))


with tempfile.TemporaryDirectory() as top:
    source, there, here = (os.path.join(top, name) for name in ("answer.cpp", "there", "here"))
    for build, text in ((there, "the other build"), (here, "")):
        os.makedirs(os.path.join(build, "config", "inner"))
        open(os.path.join(build, "CMakeCache.txt"), "w").close()
        with open(os.path.join(build, "config", "inner", "answer.h"), "w") as f:
            f.write("#define ANSWER 42\n")
    with open(source, "w") as f:
        f.write('#include "inner/answer.h"\nint answer() { return ANSWER; }\n')
    with open(os.path.join(there, "answer.o"), "w") as f:
        f.write("of the other build")
    words = "c++ -I%s/config -O2 -o answer.o -c " + source
    with open(os.path.join(there, "compile_commands.json"), "w") as f:
        json.dump([{"directory": there, "command": words % there, "file": source}], f)

    def taken(command):
        subprocess.run([sys.executable, TOOL, there] + command.split(), cwd=here, check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(here, "answer.o"), "rb") as f:
            return f.read() == b"of the other build"

    given = (words % here).replace("-o answer.o", "-MD -MT answer.o -MF answer.d -o answer.o")
    expect("the same command takes the object", taken(given), True)
    with open(os.path.join(here, "answer.d")) as f:
        expect("its dependencies", f.read(), "answer.o: %s\n" % source)
    expect("another flag compiles", taken(given.replace("-O2", "-O1")), False)
    with open(os.path.join(here, "config", "inner", "answer.h"), "w") as f:
        f.write("#define ANSWER 43\n")
    expect("another generated header compiles", taken(given), False)
sys.exit(failed > 0)
