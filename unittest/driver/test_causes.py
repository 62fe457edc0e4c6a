"""Messages of ./sphtm name the true cause, and what to do: no network, no HOME, a cache that cannot be written, a full
disk, no mpirun; and paths may have spaces."""
import hashlib
import os
import re
import subprocess

from driver_case import SOURCE, Case, end, say


def says(name, answer, *fragments, never=()):
    out, status = answer
    missing = [f for f in fragments if f not in out] + ["not: " + f for f in never if f in out]
    say(status not in (0, 124) and not missing, name, "%s; status %d; missing: %s" % (out[-1500:], status, missing))


def fresh():
    """A Debian where all packages are installed, and whose index can be fetched."""
    c = Case()
    c.stub("dpkg-query", "echo 'ii '")
    c.stub("apt-get", """case "$*" in
indextargets*) echo 'Debian|Debian|main|Packages|file:/nowhere/debian' ;;
esac
""")
    return c


c = fresh()
c.environment.pop("HOME", None)
c.environment.pop("SPHTM_CACHE")
says("no HOME", c.sphtm("env"), "HOME is not set", "SPHTM_CACHE", never=["parameter not set"])
says("an empty HOME", c.sphtm("build", HOME=""), "HOME is not set", "SPHTM_CACHE")

c = fresh()
in_the_way = c.write(c.top, "file")
says("a cache that cannot be made", c.sphtm("build", SPHTM_CACHE=os.path.join(in_the_way, "cache")),
     "cannot make the cache folder", "Not a directory", "SPHTM_CACHE")
os.makedirs(os.path.join(c.cache, "source.lock"))
says("a lock that is a folder", c.sphtm("build"), "source.lock is not a file")
if os.geteuid():
    c = fresh()
    os.makedirs(c.cache, 0o555)
    says("a cache that cannot be written", c.sphtm("build"), "cannot write into the cache folder", "SPHTM_CACHE")

c = fresh()
c.stub("df", "echo head; echo 'disk 100 90 10240 90% /disk'")
says("a full disk", c.sphtm("build"), "needs 1000 MiB", "10 MiB left", "SPHTM_CACHE")

c = fresh()
says("a source that Debian no longer has", c.sphtm("build"), "Debian trixie no longer has lammps",
     "SPHTM_LAMMPS_SOURCE")
c.stub("apt-get", """case "$*" in
indextargets*) echo 'Debian|Debian|main|Packages|file:/nowhere/debian' ;;
*update*)
  echo "W: Failed to fetch file:/nowhere/debian/InRelease  Temporary failure resolving 'nowhere'"
  case "$*" in *Error-Mode=any*) exit 100 ;; esac ;;
esac
""")
says("no network", c.sphtm("build"), "could not be fetched", "no network", "SPHTM_LAMMPS_SOURCE",
     never=["no longer has"])
c.stub("dpkg-query", "exit 1")
c.stub("sudo", 'exec "$@"')
c.stub("apt-get", "echo 'W: Failed to fetch x  Temporary failure resolving y'; exit 100")
says("no network for packages", c.sphtm("build"), "could not install", "no network")
says("an interrupted download leaves no folder behind", (str(os.listdir(c.cache)), 1), "source.lock", never=["unpack."])

# a folder of the user's where LAMMPS's source would go
c = fresh()
mine = c.write(c.cache, "lammps-20250204+dfsg.1", "mine")
says("the place of the source is taken", c.sphtm("build"), "is in the way", "SPHTM_CACHE")
unpack = c.write(c.cache, "unpack.mine", "mine")
c.sphtm("build")
say(os.path.exists(mine) and os.path.exists(unpack), "folders of the user stay where LAMMPS's source is fetched")

# which LAMMPS
c = fresh()
says("a LAMMPS that there is not", c.sphtm("build", "--lammps", "20220101"), "no LAMMPS '20220101'", "20260704")
says("an option without its word", c.sphtm("build", "--lammps"), "--lammps 20250204|20260704")
says("the other LAMMPS", c.sphtm("host", "plain", "--lammps", "20260704"), "Debian testing no longer has lammps_20260704",
     never=["trixie"])
says("the other LAMMPS, by the environment", c.run("./sphtm", "build", SPHTM_LAMMPS="20260704"),
     "Debian testing no longer has lammps_20260704", never=["trixie"])
source = os.path.dirname(os.path.dirname(c.write(c.top, "lammps", "src", "version.h")))
for name in "cmake", "curl":
    c.stub(name, "exit 1")
for version, fragment in ("20250204", "needs Kokkos 4.5.01 or later, but not 5,"), ("20260704", "needs Kokkos 5.1 or later"):
    out, status = c.run("tools/host-kokkos.sh", "openmp", SPHTM_LAMMPS=version, SPHTM_LAMMPS_SOURCE=source)
    say(status == 77 and fragment in out, "no Kokkos for LAMMPS %s" % version, out)
    out, status = c.run("tools/host-kokkos.sh", "openmp", "quiet", SPHTM_LAMMPS=version, SPHTM_LAMMPS_SOURCE=source)
    say(status == 77 and not out, "the same, quietly", out)


# an archive of its own takes the place of LAMMPS's, with a top folder and without
def archive(c, version, tarball, top):
    tree = os.path.join(c.top, "tree")
    for folder in "src", "examples/PACKAGE", "cmake":
        c.write(tree, folder, "version.h" if folder == "src" else "file", text="%s of %s" % (folder, version))
    subprocess.run(["tar", "-caf", os.path.join(c.top, tarball)] + (["--transform", "s,^,%s/," % top] if top else []) +
                   ["src", "examples", "cmake"], cwd=tree, check=True)
    with open(os.path.join(c.top, tarball), "rb") as f:
        digest = hashlib.sha256(f.read()).hexdigest()
    script = os.path.join(c.checkout, "tools", "lammps-source.sh")
    with open(script) as f:
        text = re.sub(r"sha256=[0-9a-f]{64}", "sha256=" + digest, f.read())
    with open(script, "w") as f:
        f.write(text)
    c.stub("apt-get", """case "$*" in
indextargets*) echo 'Debian|Debian|main|Packages|file:/nowhere/debian' ;;
*print-uris*) echo "'file:%s' %s 1 SHA256:%s" ;;
esac
""" % (os.path.join(c.top, tarball), tarball, digest))


for version, tarball, top in (("20250204", "lammps_20250204+dfsg.1.orig.tar.xz", "lammps-20250204"),
                              ("20260704", "lammps_20260704+dfsg.orig.tar.gz", "")):
    c = fresh()
    archive(c, version, tarball, top)
    for again in "", ", again":
        out, status = c.run("tools/lammps-source.sh", SPHTM_LAMMPS=version)
        folder = out.splitlines()[-1] if out else ""
        say(status == 0 and os.path.isfile(os.path.join(folder, "src", "version.h")) and
            os.path.isfile(os.path.join(folder, "cmake", "file")) and
            not os.path.exists(os.path.join(folder, "examples", "PACKAGE", "file")),
            "the source of %s is unpacked, %s a top folder%s" % (version, "with" if top else "without", again), out)
    says("clean takes it again", (str(c.run("./sphtm", "clean", "all")) + str(os.path.exists(folder)), 1), "False",
         never=["no mark"])

# builds that stop
c = fresh()
host = os.path.dirname(c.write(c.top, "a host", "host-plain-1", "source", text="/nowhere"))
c.write(host, "lmp")
c.stub("cmake", ': > "$4/build.ninja"')
c.stub("ninja", "echo '[1/9] a'; echo 'c++: fatal error: error writing: No space left on device'; exit 1")
says("a build on a full disk", c.run("tools/build-plugin.sh", host), "the disk is full", "the build failed")
c.stub("ninja", "echo 'c++: fatal error: Killed signal terminated program cc1plus'; exit 1")
says("a build without memory", c.run("tools/build-plugin.sh", host), "not enough memory", "SPHTM_JOBS=1")
c.stub("ninja", "echo '[1/1] a'")
out, status = c.run("tools/build-plugin.sh", host)
say(status == 0 and out.splitlines()[-1] == os.path.join(c.checkout, "build", "plain-1"),
    "a plugin is built in a checkout with spaces", out)
again = os.path.join(c.checkout, "build", "plain-1")
c.stub("cmake", ': > "$4/build.ninja"; echo configured >> "$4/times"')
for found, times in ("/usr", 0), ("YAML_LIBRARY-NOTFOUND", 1):
    c.write(again, "CMakeCache.txt", text="YAML_LIBRARY:FILEPATH=%s\n" % found)
    for targets in (), ("all",):
        c.run("tools/build-plugin.sh", host, *targets)
    count = len(open(os.path.join(again, "times")).readlines()) if times else int(os.path.exists(os.path.join(again, "times")))
    say(count == times, "configured again for tests whose packages have come, times %d" % times, str(count))
c.stub("ninja", """echo '[1/2] a'
for k in $(seq 100); do ! grep -q '50%' "$SPHTM_SAID" || { echo '[2/2] b'; exit 0; }; sleep 0.1; done; exit 1""")
said = os.path.join(c.top, "said")
out, status = c.run("sh", "-c", 'tools/build-plugin.sh "$1" 2> "$SPHTM_SAID"', "sh", host, SPHTM_SAID=said)
with open(said) as f:
    say(status == 0, "the progress of a build is told while it runs", f.read())

# mpirun
empty = os.path.join(c.top, "no mpirun")
os.makedirs(empty)
for folder in os.environ["PATH"].split(":"):
    for name in os.listdir(folder) if os.path.isdir(folder) else ():
        if name != "mpirun" and not os.path.lexists(os.path.join(empty, name)):
            os.symlink(os.path.join(folder, name), os.path.join(empty, name))
says("no mpirun", c.run("tools/print-env.sh", host, "/plugin", PATH=empty), "no mpirun on PATH", "openmpi-bin")

# what ./sphtm env prints, and the command of README.md, with spaces in all paths
c.stub("mpirun", 'case $1 in --version) ;; *) shift 2; exec "$@" ;; esac')
c.write(host, "lmp", text='#!/bin/sh\necho "lmp of $LAMMPS_PLUGIN_PATH gets $*"\n')
os.chmod(os.path.join(host, "lmp"), 0o755)
with open(os.path.join(SOURCE, "README.md")) as f:
    command = [line.strip() for line in f if "$SPHTM_MPIRUN -np" in line]
out, status = c.run("sh", "-euc", 'eval "$(tools/print-env.sh "%s" "/a plug\'in")"\n%s' % (host, command[0]))
say(status == 0 and out == "lmp of /a plug'in gets -in in.script\n", "README's command with spaces in the paths", out)
end()
