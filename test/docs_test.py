#!/usr/bin/env python3
"""What the documents name is there: linked files, tests, launch files and their arguments.

usage: docs_test.py SOURCE_DIR
"""
import pathlib
import re
import sys
import xml.etree.ElementTree

LINK = re.compile(r'\]\((?!https?:)([^)#\s]+)')
TEST = re.compile(r'`([A-Z]\w+)\.([A-Z]\w+)`')
DEFINED = re.compile(r'\b(?:TEST|TEST_F|TEST_P)\(\s*(\w+)\s*,\s*(\w+)\s*\)')
LAUNCH = re.compile(r'\b(?:roslaunch (?:mbncc_vision )?)(\w+\.launch)((?:[ \t]+\w+:=[^\s`]+)*)')


def defined_tests(root):
    return {names for path in (root / 'test').rglob('*.cpp') for names in DEFINED.findall(path.read_text())}


def arguments_of(root, launch):
    """Names of a launch file's arguments, None where there is no such file."""
    path = root / 'launch' / launch
    if not path.is_file():
        return None
    return {arg.get('name') for arg in xml.etree.ElementTree.parse(path).getroot().findall('arg')}


def launch_faults(root, text):
    for launch, given in LAUNCH.findall(text):
        known = arguments_of(root, launch)
        if known is None:
            yield f'there is no launch/{launch}'
            continue
        for name in set(re.findall(r'(\w+):=', given)) - known:
            yield f'{launch} has no argument {name}'


def faults_of(path, root, tests):
    text = path.read_text()
    for link in LINK.findall(text):
        if not (path.parent / link).exists():
            yield f'links {link}, which is not there'
    for name in TEST.findall(text):
        if name not in tests:
            yield f'names the test {".".join(name)}, which is not there'
    yield from launch_faults(root, text)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    documents = [root / 'README.md', root / 'bench' / 'README.md', *sorted((root / 'docs').rglob('*.md'))]
    tests = defined_tests(root)
    faults = [f'{path.relative_to(root)} {fault}' for path in documents for fault in faults_of(path, root, tests)]
    print('\n'.join(faults) or f'{len(documents)} documents name what is there')
    return 1 if faults or not tests else 0


if __name__ == '__main__':
    sys.exit(main())
