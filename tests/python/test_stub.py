"""The stub has the names and signatures of the module, and everything is documented."""
import ast
import re
import types
import unittest
from pathlib import Path

import pedzone

STUB = Path(pedzone.__file__).with_name("__init__.pyi")
SIGNATURE = re.compile(r"^(\w+)\((.*)\)(?: -> .*)?$")


def stub_tree():
    return ast.parse(STUB.read_text(encoding="utf-8"))


def shown(node):
    return None if node is None else ast.unparse(node)


def parameters(function):
    """[(name, kind, default)] of a function in a syntax tree, without `self`."""
    arguments = function.args
    plain = arguments.posonlyargs + arguments.args
    defaults = [None] * (len(plain) - len(arguments.defaults)) + arguments.defaults
    found = [(one.arg, "plain", shown(default)) for one, default in zip(plain, defaults)]
    found += [(one.arg, "keyword", shown(default))
              for one, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return [one for one in found if one[0] != "self"]


def real_parameters(function):
    """The same of a function of the module, from the first line of its text."""
    name, given = SIGNATURE.match(function.__doc__.splitlines()[0]).groups()
    given = re.sub(r"(?<=: )[^=*]*?(?=( = |, \w+: |, \*|$))", "object", given)  # types, by C++'s names
    tree = ast.parse(f"def {name}({given}): ...")
    return parameters(tree.body[0])


def stub_members(body):
    """{name: "property", "attribute" or its parameters} of a class or the module in the stub."""
    found = {}
    for node in body:
        if isinstance(node, ast.FunctionDef):
            decorators = [shown(one) for one in node.decorator_list]
            found[node.name] = "property" if "property" in decorators else parameters(node)
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = "attribute"
    return found


def real_members(owner):
    found = {}
    for name, value in vars(owner).items():
        value = getattr(value, "__func__", value)  # of a static method
        if name.startswith("_") and name not in ("__init__", "__len__", "__contains__", "__repr__"):
            continue
        if isinstance(value, types.WrapperDescriptorType):
            continue  # an __init__ that makes nothing: objects come from elsewhere
        if isinstance(value, property):
            found[name] = "property" if value.fset is None else "attribute"
        elif callable(value):
            found[name] = real_parameters(value)
        else:
            found[name] = "attribute"
    return found


def classes(of_stub):
    if of_stub:
        return {node.name: node for node in stub_tree().body if isinstance(node, ast.ClassDef)}
    return {name: value for name, value in vars(pedzone).items() if isinstance(value, type)}


class Stub(unittest.TestCase):
    maxDiff = None

    def test_classes_have_the_same_members(self):
        real, stub = classes(False), classes(True)
        self.assertGreater(len(stub), 8)
        self.assertEqual(set(real), set(stub))
        for name, node in stub.items():
            if name == "InputError":
                continue  # an exception like any other
            with self.subTest(name):
                self.assertEqual(real_members(real[name]), stub_members(node.body))

    def test_functions_and_constants_are_the_same(self):
        stub = {name: what for name, what in stub_members(stub_tree().body).items()}
        for name in stub:
            self.assertTrue(hasattr(pedzone, name), name)
        for name, value in vars(pedzone).items():
            if name.startswith("_") or isinstance(value, type):
                continue
            with self.subTest(name):
                self.assertIn(name, stub)
                if callable(value):
                    self.assertEqual(real_parameters(value), stub[name])

    def test_all_is_documented(self):
        for owner in [pedzone, *classes(False).values()]:
            for name, value in vars(owner).items():
                if name.startswith("_") or not (callable(value) or isinstance(value, property)):
                    continue
                own_text = value.__doc__ or ""
                if not isinstance(value, (property, type)):
                    own_text = re.sub(r"^\w+\(.*\)( -> .*)?\n*", "", own_text)
                self.assertTrue(own_text.strip(), f"{owner.__name__}.{name} has no text")

    def test_the_check_sees_a_difference(self):
        one, other = (ast.parse(text).body[0] for text in
                      ("def f(self, a, *, b=1): ...", "def f(self, a, b=1): ..."))
        self.assertNotEqual(parameters(one), parameters(other))
        self.assertEqual(parameters(one), [("a", "plain", None), ("b", "keyword", "1")])


if __name__ == "__main__":
    unittest.main()
