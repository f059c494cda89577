"""The stubs say what the extensions have."""

import ast
import re
from pathlib import Path

import clast
import pytest
from clast import _core, _reconstruct

FOLDER = Path(clast.__file__).parent


def stub(module):
    name = module.__name__.split(".")[-1]
    return ast.parse((FOLDER / f"{name}.pyi").read_text(encoding="utf-8"))


def names(body):
    """Functions, classes and variables, with the nodes."""
    found = {}
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = node
    return found


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def parameters(node):
    arguments = node.args
    return [a.arg for a in arguments.posonlyargs + arguments.args + arguments.kwonlyargs]


@pytest.mark.parametrize("module", [_core, _reconstruct])
def test_every_name_is_in_the_stub_and_no_other(module):
    assert names(stub(module).body).keys() == public(module)


def classes():
    return [(name, node) for name, node in names(stub(_core).body).items()
            if isinstance(node, ast.ClassDef)]  # fmt: skip


@pytest.mark.parametrize(("name", "node"), classes())
def test_every_member_is_in_the_stub_and_no_other(name, node):
    stubbed = {member for member in names(node.body) if not member.startswith("_")}
    kind = getattr(_core, name)
    if issubclass(kind, Exception):
        return
    assert stubbed == public(kind)
    for member, declared in names(node.body).items():
        if member.startswith("_"):
            continue
        is_property = isinstance(declared, ast.AnnAssign) or bool(declared.decorator_list)
        assert isinstance(vars(kind)[member], property) == is_property, member


def test_parameters_are_named_as_the_extension_names_them():
    checked = 0
    for name, node in names(stub(_core).body).items():
        members = names(node.body) if isinstance(node, ast.ClassDef) else {}
        functions = {name: (node, _core)} if isinstance(node, ast.FunctionDef) else {
            member: (declared, getattr(_core, name)) for member, declared in members.items()
            if isinstance(declared, ast.FunctionDef) and not declared.decorator_list
        }  # fmt: skip
        for function, (declared, owner) in functions.items():
            text = getattr(owner, function).__doc__ or ""
            signature = text.splitlines()[0] if text else ""
            if "arg0" in signature or "(" not in signature:
                continue  # without names
            found = re.findall(r"[(,] \*{0,2}(\w+)|\((\w+)[:,]", signature)
            expected = [a or b for a, b in found if (a or b) != "kwargs"]
            assert parameters(declared)[: len(expected)] == expected, function
            checked += 1
    assert checked >= 3


def test_everything_public_is_documented():
    for name in clast.__all__:
        thing = getattr(clast, name)
        if name in ("__version__", "schemes"):
            continue
        assert thing.__doc__, name
        if isinstance(thing, type) and not issubclass(thing, (Exception, tuple, dict)):
            for member in public(thing):
                value = vars(thing)[member]
                assert getattr(value, "__doc__", None), f"{name}.{member}"
