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

    def test_no_two_layers_have_types_of_one_name(self):
        """What a header shows beside other types has its name alone, whatever its namespace."""
        named = defaultdict(set)
        for path in sources("src"):
            types = types_of(path.read_text(encoding="utf-8")) if path.suffix == ".hpp" else []
            outer = {name for name, _ in types}
            for name, _ in types:
                space, _, last = name.rpartition("::")
                # `remembered` has SUMO's own names on purpose.
                if space not in outer and space != "pedzone::remembered":
                    named[last].add(name)
        self.assertGreater(len(named), 100)
        self.assertEqual({last: names for last, names in named.items() if len(names) > 1}, {})


# Folders inside a layer that is one library, in the order of who may include whom.
FOLDERS = {"crowd": ["crowd/state", "crowd/sense", "crowd/behaviour", "crowd/motion"]}


class Layers(unittest.TestCase):
    def layers(self):
        """Folders below src, lowest first. What has no folder inside a layer is on top of those that have."""
        def listed(folder, pattern):
            text = (PROJECT / "src" / folder / "CMakeLists.txt").read_text(encoding="utf-8")
            return re.findall(pattern, text)
        order = []
        for layer in listed("", r"foreach\(layer ([\w ]+)\)")[0].split():
            if layer == "sumo":
                order += ["sumo/" + inner for inner in listed("sumo", r"add_subdirectory\((\w+)\)")]
            order += FOLDERS.get(layer, []) + [layer]
        return order

    def layer_of(self, file, layers):
        folders = file.split("/")[:-1]
        inner = "/".join(folders[:2])
        return layers.index(inner if inner in layers else folders[0])

    def test_no_include_runs_back_up(self):
        layers = self.layers()
        self.assertGreater(len(layers), 10)
        self.assertEqual([layer for layer in layers if layer.startswith("sumo/")],
                         ["sumo/files", "sumo/plan", "sumo/calls", "sumo/live"])
        for path in sources("src"):
            own = self.layer_of(str(path.relative_to(PROJECT / "src")), layers)
            text = path.read_text(encoding="utf-8")
            for include in re.findall(r'^#include "(\w+/[^"]+)"', text, re.MULTILINE):
                if include.split("/")[0] in layers:
                    self.assertLessEqual(self.layer_of(include, layers), own, f"{path}: {include}")

    def test_only_thin_files_call_sumo(self):
        """All else plans over plain values, so that another client of SUMO changes these alone."""
        thin = {f"sumo/calls/{name}" for name in
                ("api.hpp", "session.cpp", "persons.cpp", "vehicles.cpp", "view.cpp",
                 "in_process.cpp", "move_batch.cpp", "over_traci.cpp", "remembered.hpp",
                 "remembered.cpp")}
        callers = set()
        for path in sources("src"):
            file, text = str(path.relative_to(PROJECT / "src")), path.read_text(encoding="utf-8")
            if re.search(r'#include ("sumo/calls/(api|remembered).hpp"|<libsumo/)', text):
                callers.add(file)
        self.assertEqual(callers, thin)

    def test_includes_run_in_no_circle(self):
        includes = {}
        for path in sources("src"):
            text = path.read_text(encoding="utf-8")
            includes[str(path.relative_to(PROJECT / "src"))] = re.findall(
                r'^#include "(\w+/[^"]+)"', text, re.MULTILINE)
        done, open_ = set(), []

        def visit(file):
            self.assertNotIn(file, open_, "a circle")
            if file in done:
                return
            open_.append(file)
            for include in includes.get(file, []):
                visit(include)
            open_.pop()
            done.add(file)
        for file in includes:
            visit(file)


if __name__ == "__main__":
    PROJECT = Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1])
