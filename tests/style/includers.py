#!/usr/bin/env python3
"""Of the files on standard input those that changed, or that include what changed, directly or not.

usage: includers.py CHANGED <FILES      CHANGED: a file with a path from the top of the tree on each line
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
changed = set(pathlib.Path(sys.argv[1]).read_text(encoding='utf-8').split())
headers = {}  # of each header, and of files as they are asked for: what it includes


def includes_of(path):
    """Files of the tree that a file names: next to it, in common/, in chapters/, in a tool's folder."""
    if path not in headers:
        found = []
        for name in INCLUDE.findall(pathlib.Path(path).read_text(encoding='utf-8')):
            folders = [pathlib.Path(path).parent, 'common', 'chapters', *pathlib.Path(path).parents]
            found += [str(pathlib.Path(folder) / name) for folder in folders if (pathlib.Path(folder) / name).is_file()][:1]
        headers[path] = found
    return headers[path]


def is_touched(path, seen):
    if path in changed:
        return True
    seen.add(path)
    return any(is_touched(each, seen) for each in includes_of(path) if each not in seen)


for line in sys.stdin:
    if is_touched(line.strip(), set()):
        print(line.strip())
