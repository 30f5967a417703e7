#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what a release needs: one version, a readable changelog, a maintainer, and a licence line in every source file.

usage: release_test.py SOURCE_DIR
"""
import pathlib
import re
import sys

from catkin_pkg.changelog import Changelog, populate_changelog_from_rst
from catkin_pkg.package import parse_package

LICENCE = 'SPDX-License-Identifier: BSD-3-Clause'
LICENSED_SUFFIXES = ('.cpp', '.hpp', '.inc', '.py', '.cmake', '.launch', '.test', '.yaml', '.msg', '.srv', '.action', '.sh')


def source_files(root):
    folders = [path for path in root.iterdir() if path.is_dir() and not re.match(r'build|\.git$', path.name)]
    return [path for folder in folders for path in folder.rglob('*') if path.is_file()] + [root / 'CMakeLists.txt']


def lacks_licence(path):
    with path.open('rb') as file:
        head = file.read(200).decode(errors='replace')
    source = path.suffix in LICENSED_SUFFIXES or path.name == 'CMakeLists.txt' or head.startswith('#!')
    return source and LICENCE not in '\n'.join(head.splitlines()[:2])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1])
    package, examples = (parse_package(str(root / folder)) for folder in ('.', 'examples'))
    warnings = []
    package.validate(warnings)
    assert not warnings, warnings
    project = re.search(r'project\(mbncc_vision VERSION ([\d.]+)', (root / 'CMakeLists.txt').read_text()).group(1)
    assert package.version == examples.version == project, (package.version, examples.version, project)
    assert package.urls and package.licenses == ['BSD-3-Clause'], 'url or licence is missing'
    for each in (package, examples):
        assert each.maintainers and 'example.org' not in each.maintainers[0].email, each.maintainers
    unlicensed = [str(path.relative_to(root)) for path in source_files(root) if lacks_licence(path)]
    assert not unlicensed, 'without the line "%s" at the head: %s' % (LICENCE, unlicensed)
    # The heading as catkin_prepare_release renames it.
    released = re.sub(r'^Forthcoming\n-+$', '9.9.9 (2026-01-01)\n------------------', (root / 'CHANGELOG.rst').read_text(),
                      flags=re.MULTILINE)
    changelog = Changelog('mbncc_vision')
    populate_changelog_from_rst(changelog, released)
    sections = {version: content for version, _, content in changelog.foreach_version()}
    assert sections.get('9.9.9') or sections.get(project), 'CHANGELOG.rst cannot be read, or tells nothing of this version'
    print('version %s can be released' % project)


main()
