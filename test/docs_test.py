#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the documents' references exist: linked files and headings, tests, launch files and their arguments,
and that the messages of a lesson in docs/console.md occur in the sources.

usage: docs_test.py SOURCE_DIR
"""
import pathlib
import re
import sys
import xml.etree.ElementTree

LINK = re.compile(r'\]\((?!https?:)([^)#\s]*)#?([^)\s]*)\)')
HEADING = re.compile(r'^#+ (.*)$', re.MULTILINE)
TEST = re.compile(r'`(?:All/)?([A-Z]\w*)?\.([A-Z]\w+|\*)`')  # also `.Case` for the previously named suite, and `Suite.*`
PYTHON_TEST = re.compile(r'`(test_\w+)`')
DEFINED = re.compile(r'\b(?:TEST|TEST_F|TEST_P)\(\s*(\w+)\s*,\s*(\w+)\s*\)')
LAUNCH = re.compile(r'\b(?:roslaunch (?:mbncc_vision )?)(\w+\.launch)((?:[ \t]+\w+:=[^\s`]+)*)')


SENTENCE_END = re.compile(r'(?<=[.:]) (?=[A-Z\'])')
VARIABLE = re.compile(r"'\w+'|\b(?:GOOD|MARGINAL|BAD)\b|\d[\d.]*")  # in a message: name, verdict, number


def defined_tests(root):
    tests = {names for path in (root / 'test').rglob('*.cpp') for names in DEFINED.findall(path.read_text())}
    return tests | {(suite, '*') for suite, _ in tests} | {('', case) for _, case in tests}


def defined_python_tests(root):
    return {name for path in (root / 'test').rglob('*.py') for name in re.findall(r'def (test_\w+)', path.read_text())}


def anchors_of(text):
    """Anchors that GitHub generates for headings."""
    return {re.sub(r'[^\w\- ]', '', heading).lower().replace(' ', '-') for heading in HEADING.findall(text)}


def link_faults(path, text):
    for link, anchor in LINK.findall(text):
        target = path.parent / link if link else path
        if not target.exists():
            yield f'links {link}, which is not there'
        elif anchor and anchor not in anchors_of(target.read_text()):
            yield f'links the heading {anchor} of {target.name}, which is not there'


def test_faults(text, tests, python_tests):
    for name in TEST.findall(text):
        if name not in tests:
            yield f'names the test {".".join(name)}, which is not there'
    for name in set(PYTHON_TEST.findall(text)) - python_tests:
        yield f'names the test {name}, which is not there'


def arguments_of(root, launch):
    """Names of a launch file's arguments; None if there is no such file."""
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


def literals_of(root):
    """All sources with adjacent string literals joined."""
    sources = [path for folder in ('src', 'include') for path in sorted((root / folder).rglob('*.[ch]pp'))]
    return '\n'.join(re.sub(r'"\s*"', '', path.read_text()) for path in sources)


def quoted_messages(text):
    """The last column of the table of messages."""
    table = text.split('## Messages of a lesson')[1].split('\n## ')[0]
    rows = [line.strip('| ').split(' | ') for line in table.splitlines() if line.startswith('|')]
    return [row[-1] for row in rows[2:]]


def message_faults(text, literals):
    messages = quoted_messages(text)
    if not messages:
        yield 'quotes no message of a lesson'
    for message in messages:
        for sentence in SENTENCE_END.split(message):
            for part in VARIABLE.split(sentence):
                words = part.strip(' .')
                if words not in literals:
                    yield f'quotes "{message}", but "{words}" stands in no source'


def faults_of(path, root, tests, python_tests):
    text = path.read_text()
    yield from link_faults(path, text)
    yield from test_faults(text, tests, python_tests)
    yield from launch_faults(root, text)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    literals = literals_of(root)
    documents = [root / 'README.md', root / 'bench' / 'README.md', *sorted((root / 'docs').rglob('*.md'))]
    tests, python_tests = defined_tests(root), defined_python_tests(root)
    faults = [f'{path.relative_to(root)} {fault}'
              for path in documents for fault in faults_of(path, root, tests, python_tests)]
    console = root / 'docs' / 'console.md'
    faults += [f'docs/console.md {fault}' for fault in message_faults(console.read_text(), literals)]
    print('\n'.join(faults) or f'{len(documents)} documents have valid references')
    return 1 if faults or not tests else 0


if __name__ == '__main__':
    sys.exit(main())
