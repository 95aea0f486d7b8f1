"""The reference decoder: python3 spec/decoder IN.dmsh OUT.ply [--json] [--dump]"""
import argparse
import json
import logging
import sys

import numpy as np

import ply
from container import Broken
from mesh import decode

def main():
    parser = argparse.ArgumentParser(prog="decoder", description="Decodes a deltamesh stream, rule by rule.")
    parser.add_argument("stream")
    parser.add_argument("out", nargs="?", help="a PLY file")
    parser.add_argument("--json", action="store_true", help="print the header and the figures")
    parser.add_argument("--dump", action="store_true", help="print intermediate values")
    options = parser.parse_args()
    if options.dump:
        np.set_printoptions(threshold=sys.maxsize, floatmode="unique")
        logging.basicConfig(level=logging.DEBUG, stream=sys.stdout, format="%(message)s")
    with open(options.stream, "rb") as file:
        data = file.read()
    try:
        mesh = decode(data)
    except Broken as error:
        sys.exit(f"{options.stream}: {error}")
    if options.json:
        attributes = [{"name": a.name.decode("utf-8", "replace"), "kind": a.kind, "type": a.type, "components": a.k,
                       "error": a.error} for a in mesh.attributes]
        print(json.dumps(vars(mesh.header) | {"attributes": attributes}, indent=2))
    if options.out:
        ply.write(options.out, mesh)

if __name__ == "__main__":
    main()
