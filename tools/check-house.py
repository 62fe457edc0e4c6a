#!/usr/bin/python3
"""The size of the source: lines and files per folder, the longest functions, the largest classes.

    check-house.py [--src FOLDER] [--limits]    the tables; with --limits it fails where one is exceeded
    check-house.py --self-test                  made-up files at and above the limits

A function counts from the first line of its head to its closing brace. Methods of a class are the functions that
its body declares, constructors and overrides included; members are the variables, constants (static constexpr) aside.
Macros count as lines only; of #if ... #else ... only the first branch is read for functions and classes."""
import argparse
import collections
import os
import re
import sys
import tempfile

LONGEST_FUNCTION = 120    # lines
MOST_METHODS = 35
SHOWN = 10
SUFFIXES = (".h", ".c", ".cpp", ".cu")

Function = collections.namedtuple("Function", "lines name path line")
Class = collections.namedtuple("Class", "methods members name path line")


def blank(match):
    return re.sub(r"[^\n]", " ", match.group(0))


def bare(text):
    """The text without comments, strings, directives and branches behind #else; lines stay where they are."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<![0-9a-zA-Z])'(?:\\.|[^'\\\n])+'", blank, text, flags=re.S)
    out, directive, alternative = [], False, []    # alternative: of each open #if, are we behind its #else?
    for line in text.split("\n"):
        word = re.match(r"\s*#\s*(\w+)", line) if not directive else None
        if word:
            if word.group(1).startswith("if"):
                alternative.append(False)
            elif word.group(1) in ("else", "elif") and alternative:
                alternative[-1] = True
            elif word.group(1) == "endif" and alternative:
                alternative.pop()
        inside = directive or bool(word)
        directive = inside and line.rstrip().endswith("\\")
        out.append("" if inside or any(alternative) else line)
    return "\n".join(out)


def plain(head):
    """A declaration without template arguments, labels and macro calls of their own in front."""
    head = re.sub(r"^(\s*(public|protected|private)\s*:(?!:))+", "", head)
    head = re.sub(r"^(\s*[A-Z][A-Z0-9_]*\s*\([^()]*\)\s*(?=[\w~]))+", "", head)
    before = None
    while before != head:
        before, head = head, re.sub(r"<[^<>(){};]*(\([^<>(){};]*\))?[^<>(){};]*>", " ", head)
    return head.strip()


def without_values(head):
    """Up to the value that a declaration gives: a function with its arguments, a variable with its name."""
    return head if "operator" in head else re.sub(r"(?<![=!<>])=(?!=).*", "", head, flags=re.S)


def function_name(head):
    for name in re.findall(r"(operator\s*[^\s\w(]+|~?[\w:~]+)\s*\(", without_values(head)):
        if name not in ("__attribute__", "alignas", "decltype", "defined", "noexcept"):
            return name
    return None


def kind(head):
    """What the brace behind this head opens, and its name."""
    words = plain(head)
    if re.search(r"\bnamespace\b", words) or re.match(r"extern\s*$", words):
        return "namespace", ""
    found = re.match(r"(?:template\s*)?(?:typedef\s+)?(?:class|struct|union)\b\s*(?:alignas\s*\([^()]*\)\s*)?(\w*)", words)
    if found and "(" not in re.sub(r"alignas\s*\([^()]*\)", "", words):
        return "class", found.group(1)
    if re.match(r"(?:typedef\s+)?enum\b", words):
        return "block", ""
    # a value in a list of initializers, as in A() : b{1} {
    if re.search(r"\)\s*:[^:]", words) and re.search(r"[\w>]\s*$", words) and \
            not re.search(r"\b(const|override|noexcept|final)\s*$", words):
        return "value", ""
    name = function_name(words)
    if name and not re.search(r"(?<![=!<>])=\s*$", words):
        return "function", name
    return "value", ""


def count_members(head):
    """Variables of one declaration; constants and what is no variable: none."""
    words = plain(head)
    if not words or re.match(r"(using|friend|typedef|enum|static_assert|class|struct|template|static\s+constexpr)\b", words):
        return 0
    before = None
    while before != words:
        before, words = words, re.sub(r"\([^()]*\)|\[[^\[\]]*\]|\{[^{}]*\}", "", words)
    return 1 + re.sub(r"=[^,]*", "", words).count(",") if re.search(r"\w", words) else 0


def read(path, shown):
    """Functions and classes of a file."""
    with open(path, encoding="utf-8", errors="replace") as f:
        text = bare(f.read())
    functions, classes = [], []
    scopes = [["namespace", "", 0, 0, 0, 0]]    # kind, name, first line, methods, members, outer head's place
    begin, parens = 0, 0
    for place in re.finditer(r"[{};()]", text):
        c, at = place.group(0), place.start()
        top = scopes[-1]
        if c == "(":
            parens += 1
        elif c == ")":
            parens = max(0, parens - 1)
        elif c == "{":
            head = text[begin:at]
            if top[0] in ("function", "block", "value") or parens:
                what, name = "block", ""
            else:
                what, name = kind(head)
            first = text.count("\n", 0, begin + len(head) - len(head.lstrip())) + 1
            if what == "function" and top[0] == "class":
                top[3] += 1
                name = top[1] + "::" + name
            scopes.append([what, name, first, 0, 0, begin, parens])
            parens = 0
            if what != "value":
                begin = at + 1
        elif c == "}" and len(scopes) > 1:
            what, name, first, methods, members, outer, parens = scopes.pop()
            last = text.count("\n", 0, at) + 1
            if what == "function":
                functions.append(Function(last - first + 1, name, shown, first))
            elif what == "class" and methods:
                classes.append(Class(methods, members, name or "(no name)", shown, first))
            if what == "value":
                begin = outer    # the declaration goes on
            else:
                begin = at + 1
        elif c == ";" and not parens:
            if top[0] == "class":
                head = text[begin:at]
                words = plain(head)
                if not re.match(r"(using|friend|typedef|static_assert)\b", words) and function_name(words):
                    top[3] += 1
                else:
                    top[4] += count_members(head)
            begin = at + 1
    return functions, classes


def measure(source):
    folders = collections.OrderedDict()
    functions, classes = [], []
    for folder, below, files in sorted(os.walk(source)):
        for name in sorted(files):
            if not name.endswith(SUFFIXES):
                continue
            path = os.path.join(folder, name)
            shown = os.path.relpath(path, source)
            f, c = read(path, shown)
            functions += f
            classes += c
            with open(path, "rb") as text:
                lines = text.read().count(b"\n")
            entry = folders.setdefault(os.path.dirname(shown) or ".", [0, 0])
            entry[0] += 1
            entry[1] += lines
    functions.sort(key=lambda f: (-f.lines, f.path, f.line))
    classes.sort(key=lambda c: (-c.methods, -c.members, c.path))
    return folders, functions, classes


def tables(folders, functions, classes):
    print("%6s %7s  folder" % ("files", "lines"))
    for folder, (files, lines) in folders.items():
        print("%6d %7d  %s" % (files, lines, folder))
    print("%6d %7d  in all" % tuple(map(sum, zip(*folders.values()))))
    lengths = sorted(f.lines for f in functions)
    print("\n%d functions; median %d lines, 90 %% up to %d" %
          (len(lengths), lengths[len(lengths) // 2], lengths[len(lengths) * 9 // 10]) if lengths else "\nno functions")
    print("%6s  longest functions" % "lines")
    for f in functions[:SHOWN]:
        print("%6d  %-42s %s:%d" % f)
    print("\n%7s %7s  classes with most methods" % ("methods", "members"))
    for c in classes[:SHOWN]:
        print("%7d %7d  %-24s %s:%d" % c)
    print("\n%7s %7s  classes with most members" % ("methods", "members"))
    for c in sorted(classes, key=lambda c: (-c.members, c.path))[:SHOWN]:
        print("%7d %7d  %-24s %s:%d" % c)


def exceeded(functions, classes):
    return ["%s:%d: function %s has %d lines, more than %d" % (f.path, f.line, f.name, f.lines, LONGEST_FUNCTION)
            for f in functions if f.lines > LONGEST_FUNCTION] + \
           ["%s:%d: class %s has %d methods, more than %d" % (c.path, c.line, c.name, c.methods, MOST_METHODS)
            for c in classes if c.methods > MOST_METHODS]


def self_test():
    def function(name, lines):
        return "TM_FN int\n%s(int i,\n  int j)\n{\n%s  return i;\n}\n" % (name, "  i += j;\n" * (lines - 6))

    def large_class(name, methods):
        declared = "".join("  virtual void f%d(int) const;\n" % k for k in range(methods - 4))
        return ("class %s : public Base {\n public:\n  %s() : a{1} {}\n  ~%s() override;\n  int get() const { return a; }\n"
                "  bool operator==(const %s &) const;\n%s\n private:\n  int a = 0, b{2};\n"
                "  std::function<int(int, int)> c;\n  static constexpr int D = f(1);\n  enum { E, F };\n"
                "  struct {\n    int g;\n  } h;\n};\n" % (name, name, name, name, declared))

    cases = (    # file, text, what must be said of it
        ("good.h", function("at_limit", LONGEST_FUNCTION), None),
        ("good.cpp", "namespace A {\n" + large_class("AtLimit", MOST_METHODS) + "}\n", None),
        ("noise.c", "/* { */ // {\n#define M(x) { \\\n  x\n#if A\nint f(int a) {\n#else\nint f(int b) {\n#endif\n"
                    "  return \"{\"[0] == '{';\n}\nstatic const int t[] = {1, 2};\n" + "\n" * 150, None),
        ("long.h", function("above", LONGEST_FUNCTION + 1), "long.h:1: function above has 121 lines"),
        ("large.h", large_class("Above", MOST_METHODS + 1), "large.h:1: class Above has 36 methods"))
    for name, text, expected in cases:
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, name), "w") as f:
                f.write(text)
            folders, functions, classes = measure(folder)
            said = exceeded(functions, classes)
            if (not said) != (expected is None) or expected and not (len(said) == 1 and said[0].startswith(expected)):
                sys.exit("%s: said %s, expected %s" % (name, said, expected))
            if classes and classes[0].members != 4:
                sys.exit("%s: %d members, expected 4 (a, b, c, h)" % (name, classes[0].members))
            if name == "noise.c" and [f.name for f in functions] != ["f"]:
                sys.exit("%s: functions %s, expected f" % (name, functions))
    print("%d made-up files are judged as expected" % len(cases))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--src", default=os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "src"))
    parser.add_argument("--limits", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        return self_test()
    folders, functions, classes = measure(options.src)
    if not folders:
        sys.exit("%s: no C or C++ files" % options.src)
    tables(folders, functions, classes)
    said = exceeded(functions, classes)
    if options.limits and said:
        sys.exit("\n" + "\n".join(said))


main()
