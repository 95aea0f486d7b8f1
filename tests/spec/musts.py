"""The places where the reference decoder rejects a stream, one for each MUST: (rule, file, line) of each line that names a rule."""
import ast
import glob
import os
import re
import traceback

DECODER = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "spec", "decoder"))


def places():
    """All places, each with whether the line calls `must` or another function with the rule; other lines, such as defaults of
    parameters, say which rule a call elsewhere names."""
    found = {}
    for path in sorted(glob.glob(os.path.join(DECODER, "*.py"))):
        with open(path, encoding="utf-8") as file:
            tree = ast.parse(file.read())
        called = {id(argument) for call in ast.walk(tree) if isinstance(call, ast.Call)
                  for argument in call.args + [keyword.value for keyword in call.keywords]}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and re.fullmatch(r"[A-Z]{3,4}-\d+", str(node.value)):
                place = node.value, os.path.basename(path), node.lineno
                if place in found:
                    raise ValueError(f"two places in one line: {place}")
                found[place] = id(node) in called
    return found


def is_of_maps(place):
    """Whether it rejects messages or parts of maps rather than streams."""
    return place[0].startswith("MAP-") or place[1] == "patches.py"


def joined():
    """Lines of `must` whose conditions are several, joined by `and`: each needs a line of its own."""
    for path in sorted(glob.glob(os.path.join(DECODER, "*.py"))):
        with open(path, encoding="utf-8") as file:
            for node in ast.walk(ast.parse(file.read())):
                if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "must" and isinstance(node.args[0], ast.BoolOp):
                    if isinstance(node.args[0].op, ast.And):
                        yield f"{os.path.basename(path)}:{node.lineno}"


def place_of(error, known):
    """The place where a Broken comes from, of those of places()."""
    for frame in reversed(traceback.extract_tb(error.__traceback__)):
        place = error.tag, os.path.basename(frame.filename), frame.lineno
        if known.get(place):
            return place
    place, = (place for place, is_call in known.items() if place[0] == error.tag and not is_call)
    return place
