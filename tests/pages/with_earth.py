#!/usr/bin/env python3
"""Chapter 00's file with the pieces of code of chapter 03's page, each put where its mark says:
<!-- earth: above "TEXT" -->.

usage: with_earth.py PAGE SOURCE OUT
"""
import pathlib
import re
import sys

page, source, out = map(pathlib.Path, sys.argv[1:])
text = source.read_text(encoding='utf-8')
pieces = re.findall(r'^<!-- earth: (above|below) "([^"]+)" -->\n```cpp\n(.+?)\n```$',
                    page.read_text(encoding='utf-8'), re.M | re.S)
for verb, place, code in pieces:
    if text.count(place) != 1:
        sys.exit(f'{page}: {source} does not have this text once: {place}')
    text = text.replace(place, f'{code}\n{place}' if verb == 'above' else f'{place}\n{code}')
if not pieces:
    sys.exit(f'{page} has no piece of code for {source}')
out.write_text(text, encoding='utf-8')
