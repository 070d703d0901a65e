#!/usr/bin/python3
"""No name stands for two types (the one-definition rule), and no include runs back up the layers.

    test_names.py PROJECT_FOLDER

The compiler does not tell: two source files may each define a `pedzone::Scene`, and the linker keeps
one of them for both. Types in unnamed namespaces are each file's own.
"""
import re
import sys
import unittest
from collections import defaultdict
from pathlib import Path

PROJECT = None
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'',
                   re.DOTALL)
TOKEN = re.compile(r"""(?P<namespace>\bnamespace\b\s*(?P<space>[\w:]*)\s*\{)
                     |(?P<type>\b(?:struct|class|union|enum(?:\s+class)?)\s+(?:alignas\([^)]*\)\s*)?
                       (?P<name>[\w:]+)(?:\s+final)?\s*(?::(?!:)[^;{()=]*)?\{)
                     |(?P<open>\{)|(?P<close>\})""", re.VERBOSE)


def types_of(source):
    """[(qualified name, own to the file)] of the types that a text defines outside of functions."""
    text = NOISE.sub(" ", source)
    found, stack = [], []  # of (kind, name)
    for token in TOKEN.finditer(text):
        if token["namespace"]:
            stack.append(("namespace", token["space"]))
        elif token["type"]:
            if all(kind != "block" for kind, _ in stack):
                names = [name for _, name in stack] + [token["name"]]
                found.append(("::".join(names), "" in names))
            stack.append(("type", token["name"]))
        elif token["open"]:
            stack.append(("block", ""))
        elif stack:
            stack.pop()
    return found


def sources(*folders):
    for folder in folders:
        for path in sorted((PROJECT / folder).rglob("*.[ch]pp")):
            yield path


class Names(unittest.TestCase):
    def test_the_scanner_sees_types_and_what_is_a_files_own(self):
        text = """namespace a::b { struct One { struct In {}; void f() { struct Local {}; } };
                  enum class Two : int { kX }; namespace { class Own final : One {}; } }
                  // struct Comment {}
                  namespace a { template <class T> struct Three {}; const char* s = "struct S {"; }"""
        self.assertEqual(types_of(text),
                         [("a::b::One", False), ("a::b::One::In", False), ("a::b::Two", False),
                          ("a::b::::Own", True), ("a::Three", False)])

    def test_no_name_stands_for_two_types(self):
        places = defaultdict(set)
        for path in sources("src"):
            for name, own in types_of(path.read_text(encoding="utf-8")):
                if not own:
                    places[name].add(str(path.relative_to(PROJECT)))
        self.assertGreater(len(places), 100)
        for path in sources("tests"):
            for name, own in types_of(path.read_text(encoding="utf-8")):
                if not own and name in places:
                    places[name].add(str(path.relative_to(PROJECT)))
        double = {name: sorted(files) for name, files in places.items() if len(files) > 1}
        self.assertEqual(double, {})


# Folders inside a layer, in the order of who may include whom; "": the layer's own files.
FOLDERS = {"crowd": ("state", "sense", "behaviour", "motion", "")}


def includes(path):
    """The project's files that a source file includes, as paths inside src."""
    return re.findall(r'^#include "(\w+/[\w./]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)


def folder(path):
    """(layer, folder inside it) of a path inside src."""
    parts = Path(path).parts
    return parts[0], parts[1] if len(parts) > 2 else ""


class Layers(unittest.TestCase):
    def test_no_include_runs_back_up_inside_a_layer(self):
        for path in sources("src"):
            own = folder(path.relative_to(PROJECT / "src"))
            order = FOLDERS.get(own[0])
            for include in includes(path) if order else []:
                layer, other = folder(include)
                if layer == own[0]:
                    self.assertLessEqual(order.index(other), order.index(own[1]), f"{path}: {include}")

    def test_no_includes_go_round_in_a_circle(self):
        graph = {str(path.relative_to(PROJECT / "src")): includes(path) for path in sources("src")}
        self.assertGreater(len(graph), 300)
        done, way = set(), []

        def visit(file):
            self.assertNotIn(file, way, "a circle of includes")
            if file in done:
                return
            way.append(file)
            for other in graph.get(file, []):
                visit(other)
            done.add(way.pop())

        for file in graph:
            visit(file)

    def test_no_include_runs_back_up(self):
        cmake = (PROJECT / "src" / "CMakeLists.txt").read_text(encoding="utf-8")
        layers = re.search(r"foreach\(layer ([\w ]+)\)", cmake).group(1).split()
        self.assertGreater(len(layers), 10)
        for path in sources("src"):
            own = path.relative_to(PROJECT / "src").parts[0]
            text = path.read_text(encoding="utf-8")
            for include in re.findall(r'^#include "(\w+)/', text, re.MULTILINE):
                if include in layers:
                    self.assertLessEqual(layers.index(include), layers.index(own), str(path))


if __name__ == "__main__":
    PROJECT = Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1])
