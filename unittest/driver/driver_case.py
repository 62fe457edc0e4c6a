"""Cases of ./sphtm with folders and commands that stand in for the real ones: nothing is downloaded or built.

A case has a checkout of its own, in a folder with a space and a quote in its name: ./sphtm and tools/ alone."""
import atexit
import os
import shutil
import subprocess
import sys
import tempfile

SOURCE = os.environ.get("SPHTM_SOURCE", os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
failed = []


def say(ok, name, text=""):
    if not ok:
        failed.append(name)
    print("%-5s %s   %s" % ("ok" if ok else "FAIL", name, text if not ok else ""), flush=True)


def end():
    sys.exit(1 if failed else 0)


class Case:
    def __init__(self):
        self.top = tempfile.mkdtemp(prefix="sphtm-")
        atexit.register(shutil.rmtree, self.top, ignore_errors=True)
        self.checkout = os.path.join(self.top, "it's a checkout")
        self.cache = os.path.join(self.top, "the cache")
        self.stubs = os.path.join(self.top, "stubs")
        os.makedirs(self.checkout)
        os.makedirs(self.stubs)
        shutil.copy(os.path.join(SOURCE, "sphtm"), self.checkout)
        shutil.copytree(os.path.join(SOURCE, "tools"), os.path.join(self.checkout, "tools"))
        self.environment = dict(os.environ, SPHTM_CACHE=self.cache, PATH=self.stubs + ":" + os.environ["PATH"])
        for name in "SPHTM_LAMMPS", "SPHTM_LAMMPS_SOURCE", "SPHTM_LMP", "XDG_CACHE_HOME":
            self.environment.pop(name, None)

    def stub(self, name, lines):
        path = os.path.join(self.stubs, name)
        with open(path, "w") as f:
            f.write("#!/bin/sh\n" + lines)
        os.chmod(path, 0o755)
        return path

    def write(self, *path, text="a user's"):
        whole = os.path.join(*path)
        os.makedirs(os.path.dirname(whole), exist_ok=True)
        with open(whole, "w") as f:
            f.write(text)
        return whole

    def run(self, *command, **more):
        """Output and status; 30 s at most."""
        try:
            done = subprocess.run(command, cwd=self.checkout, env=dict(self.environment, **more), timeout=30, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            return done.stdout, done.returncode
        except subprocess.TimeoutExpired:
            return "waited for ever", 124

    def sphtm(self, *words, **more):
        return self.run("./sphtm", *words, **more)

    def with_common(self, lines):
        """Runs lines of shell behind those of tools/common.sh."""
        out, status = self.run("sh", "-euc", "cd tools; . ./common.sh\n" + lines, "case")
        assert status == 0, out
        return out
