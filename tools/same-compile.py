#!/usr/bin/python3
"""Compiler launcher for builds that only have to show that they work: a file that another build has compiled with the same command and
the same generated headers is taken from there, any other is compiled.
   same-compile.py BUILD COMPILER ARGUMENT...     BUILD: a finished build with compile_commands.json
"""
import filecmp
import json
import os
import shlex
import shutil
import sys


def value(words, option):
    return words[words.index(option) + 1] if option in words[:-1] else None


def known(build, words):
    """The object of that build for this command, or None."""
    here, source = os.getcwd(), value(words, "-c")
    while here != "/" and not os.path.exists(os.path.join(here, "CMakeCache.txt")):
        here = os.path.dirname(here)
    target = value(words, "-o")
    if not (source and target and here != "/"):
        return None
    if not same_headers(os.path.join(build, "config"), os.path.join(here, "config")):
        return None
    given = normal(words, here, build)
    with open(os.path.join(build, "compile_commands.json")) as f:
        for entry in json.load(f):
            if entry["file"] == source:
                command = shlex.split(entry["command"])
                if normal(command, build, build) == given:
                    return os.path.join(entry["directory"], value(command, "-o"))
    return None


def same_headers(a, b):
    names, others = files(a), files(b)
    return names == others and filecmp.cmpfiles(a, b, names, shallow=False)[0] == names


def files(folder):
    return sorted(os.path.relpath(os.path.join(at, f), folder) for at, _, inside in os.walk(folder, followlinks=True) for f in inside)


def normal(words, folder, build):
    """Without what names the object and its dependencies, paths of the one build as those of the other."""
    out, skip = [], False
    for w in words:
        if not skip and w not in ("-MD", "-o", "-MT", "-MF"):
            out.append(w.replace(folder, build))
        skip = not skip and w in ("-o", "-MT", "-MF")
    return out


def main():
    build, words = sys.argv[1], sys.argv[2:]
    there = known(build, words)
    if there is None or not os.path.exists(there):
        os.execvp(words[0], words)
    shutil.copyfile(there, value(words, "-o"))
    depends = value(words, "-MF")
    if depends:
        with open(depends, "w") as f:
            f.write("%s: %s\n" % (value(words, "-MT") or value(words, "-o"), value(words, "-c")))
    print("the same command as in %s: %s" % (build, value(words, "-c")), flush=True)


if __name__ == "__main__":
    main()
