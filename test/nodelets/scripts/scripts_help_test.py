#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every script prints its help for --help, and does nothing else.

usage: scripts_help_test.py SOURCE_DIR
"""
import pathlib
import subprocess
import sys


def is_script(path):
    return path.is_file() and path.read_text().startswith('#!')


def fault_of(script):
    told = subprocess.run([script, '--help'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
    if told.returncode != 0 or 'usage:' not in told.stdout:
        return f'{script.name} --help ended with {told.returncode}: {told.stdout}'
    return None


def main():
    scripts = sorted(filter(is_script, (pathlib.Path(sys.argv[1]) / 'scripts').iterdir()))
    faults = list(filter(None, map(fault_of, scripts)))
    print('\n'.join(faults) or f'{len(scripts)} scripts explain themselves')
    return 1 if faults or not scripts else 0


if __name__ == '__main__':
    sys.exit(main())
