#!/usr/bin/env python3
"""A release can be made: one version everywhere, a changelog that catkin_prepare_release and bloom can read.

usage: release_test.py SOURCE_DIR
"""
import pathlib
import re
import sys

from catkin_pkg.changelog import Changelog, populate_changelog_from_rst
from catkin_pkg.package import parse_package


def main():
    root = pathlib.Path(sys.argv[1])
    package, examples = (parse_package(str(root / folder)) for folder in ('.', 'examples'))
    warnings = []
    package.validate(warnings)
    assert not warnings, warnings
    project = re.search(r'project\(mbncc_vision VERSION ([\d.]+)', (root / 'CMakeLists.txt').read_text()).group(1)
    assert package.version == examples.version == project, (package.version, examples.version, project)
    assert package.urls and package.licenses == ['BSD-3-Clause'], 'url or licence is missing'
    # As catkin_prepare_release renames it.
    released = re.sub(r'^Forthcoming\n-+$', '9.9.9 (2026-01-01)\n------------------', (root / 'CHANGELOG.rst').read_text(),
                      flags=re.MULTILINE)
    changelog = Changelog('mbncc_vision')
    populate_changelog_from_rst(changelog, released)
    sections = {version: content for version, _, content in changelog.foreach_version()}
    assert sections.get('9.9.9') or sections.get(project), 'CHANGELOG.rst cannot be read, or tells nothing of this version'
    print('version %s can be released' % project)


main()
