"""./sphtm clean removes what carries a mark of ./sphtm, and nothing else: no file of a user, nothing behind a link; it
waits for nothing."""
import fcntl
import os
import shutil

from driver_case import Case, end, say


def exists(*path):
    return os.path.lexists(os.path.join(*path))


# --- a cache in a folder of the user's

c = Case()
mine = c.write(c.cache, "thesis", "chapter.tex")
loose = c.write(c.cache, "notes.txt")
named = c.write(c.cache, "host-plain-of-mine", "data")
lock = c.write(c.cache, "mine.lock")
away = c.write(c.top, "elsewhere", "data")
os.symlink(os.path.dirname(away), os.path.join(c.cache, "host-linked"))
os.mkfifo(os.path.join(c.cache, "fifo.lock"))
os.makedirs(os.path.join(c.cache, "strange"))
os.mkfifo(os.path.join(c.cache, "strange", ".sphtm-made"))
c.with_common('make_folder "$cache/host-plain-1"; make_folder "$cache/lammps-1"; make_folder "$cache/lammps-1/src"'
              '\ntouch "$cache/host-plain-1/lmp"; ln -s "%s" "$cache/host-plain-1/link"; lock source' %
              os.path.dirname(away))
shutil.copytree(os.path.join(c.cache, "lammps-1"), os.path.join(c.cache, "lammps-copy"))
out, status = c.sphtm("clean", "all")
say(status == 0, "clean all in a user's folder ends", out)
say(all(exists(p) for p in (mine, loose, named, lock, away)), "files of the user stay", out)
say(not any(exists(c.cache, p) for p in ("host-plain-1", "lammps-1", "source.lock")), "what ./sphtm made goes", out)
say(exists(c.cache, "lammps-copy"), "a copy stays", out)
for name in "thesis", "notes.txt", "host-linked", "fifo.lock", "strange", "lammps-copy", "mine.lock":
    say("left %s" % os.path.join(c.cache, name) in out, "it is said that %s stays" % name, out)
say("a link" in out, "a link is called one", out)

# --- a cache of its own, one in use, one of an earlier version

c = Case()
c.with_common('lock source; make_folder "$cache/host-plain-1"')
with open(os.path.join(c.cache, "source.lock")) as held:
    fcntl.flock(held, fcntl.LOCK_EX)
    out, status = c.sphtm("clean", "all")
    say(status == 0 and exists(c.cache, "host-plain-1") and "another sphtm works" in out, "a cache in use stays", out)
out, status = c.sphtm("clean", "all")
say(status == 0 and not exists(c.cache) and not out, "a cache of its own goes without a word", out)

c = Case()
c.write(c.cache, "host-plain-1", "lmp")
c.write(c.cache, "host-plain-1", "source")
c.write(c.cache, "source.lock", text="")
out, status = c.sphtm("clean", "all")
say(exists(c.cache, "host-plain-1") and "rm -r '%s'" % os.path.join(c.cache, "host-plain-1") in out,
    "for a cache without marks it is said how to remove it", out)

# --- build/ and out/

c = Case()
own = c.write(c.checkout, "build", "own", "CMakeCache.txt")
result = c.write(c.checkout, "out", "mine", "summary.json")
c.with_common('''make_folder "$root/build/plain-1"; touch "$root/build/plain-1/build.ninja"
lock "$(build_lock "$root/build/plain-1")"
(results_in demo); touch "$root/out/demo/summary.json"; (results_in mine)
touch "$root/out/a.tar.xz" "$root/out/b.tar.xz"; mark_file "$root/out/a.tar.xz"; mark_file "$root/out/b.tar.xz"''')
c.write(c.checkout, "out", "b.tar.xz", text="another")
build = os.path.join(c.checkout, "build", "plain-1")
say(exists(build) and exists(c.checkout, "out", "demo") and exists(c.checkout, "out", "a.tar.xz"), "all is there")
lock = [f for f in os.listdir(c.cache) if f.startswith("plugin-")][0]
with open(os.path.join(c.cache, lock)) as held:
    fcntl.flock(held, fcntl.LOCK_EX)
    out, status = c.sphtm("clean")
    say(status == 0 and exists(build) and "another sphtm works in it" in out, "a build in use stays", out)
out, status = c.sphtm("clean")
say(exists(own) and "left %s" % os.path.dirname(own) in out, "a user's build/own stays", out)
say(exists(result), "a folder of the user in out/ stays", out)
say(not exists(build) and not exists(c.checkout, "out", "demo"), "builds and results of ./sphtm go", out)
say(not exists(c.checkout, "out", "a.tar.xz") and exists(c.checkout, "out", "b.tar.xz"),
    "an archive goes, one that was replaced stays", out)
say(exists(c.cache), "clean without all leaves the cache", out)

c = Case()
c.with_common('make_folder "$root/../far/plain-1"; ln -s ../far "$root/build"')
out, status = c.sphtm("clean")
say(status == 0 and exists(c.top, "far", "plain-1") and "a link" in out, "build/ that is a link stays", out)
c.environment.pop("HOME", None)
c.environment.pop("SPHTM_CACHE")
out, status = c.sphtm("clean")
say(status == 0, "clean needs no HOME", out)
out, status = c.sphtm("clean", "all")
say(status == 1 and "HOME is not set" in out and "SPHTM_CACHE" in out, "clean all says that it needs one", out)
end()
