#!/usr/bin/env python3
"""Keeps the layers apart: a file includes only its own layer or lower ones, the core knows no ROS.

usage: layers_test.py SOURCE_DIR LIBMBNCC
"""
import pathlib
import re
import subprocess
import sys

LAYERS = {'words': 0, 'polar': 1, 'library': 2, 'matching': 2, 'learning': 3, 'miss': 3, 'cell': 4, 'sim': 4,
          'nodelets': 5, 'cli': 5, 'console': 5}
# Layers of one height do not include each other; learning may use both layers of height 2.
CORE_LIBRARIES = ('opencv2/core', 'opencv2/imgproc', 'opencv2/ximgproc', 'Eigen/', 'png.h',
                  'yaml-cpp/')
SYSTEM_HEADERS = ('sys/', 'unistd.h', 'fcntl.h', 'dirent.h', 'immintrin.h')
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
FORBIDDEN_CALLS = re.compile(r'\b(std::cout|std::cerr|std::clog|printf\s*\(|puts\s*\(|abort\s*\(|'
                             r'exit\s*\()')
ROS_LIBRARIES = ('libros', 'libtf', 'libnodelet', 'libcv_bridge', 'libimage_transport',
                 'libactionlib', 'libclass_loader', 'libxmlrpcpp')


def layer_of(path, root):
    """Layer of a file, None where it belongs to none."""
    parts = path.relative_to(root).parts
    if parts[:2] == ('src', 'core'):
        return parts[2] if len(parts) > 3 else None
    if parts[0] == 'src':
        return parts[1]
    if parts[:2] == ('include', 'mbncc'):
        return layer_of_header('/'.join(parts[1:]))
    return None


def layer_of_header(name):
    """Layer of "mbncc/..." or of a private header "<layer>/...", None for other libraries."""
    parts = name.split('/')
    if parts[0] == 'mbncc':
        if len(parts) == 2 and parts[1] in ('polar.hpp',):
            return 'polar'
        return parts[1] if len(parts) > 2 and parts[1] in LAYERS else 'words'
    return parts[0] if len(parts) > 1 and parts[0] in LAYERS else None


def is_allowed(own, other):
    return own == other or LAYERS[other] < LAYERS[own]


def without_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', '', text, flags=re.DOTALL)


def faults_of(path, root):
    own = layer_of(path, root)
    if own not in LAYERS:
        return
    text = path.read_text()
    core = LAYERS[own] < 5
    for bracket, name in INCLUDE.findall(text):
        other = layer_of_header(name) if bracket == '"' or name.startswith('mbncc') else None
        if other is not None and not is_allowed(own, other):
            yield f'layer {own} must not include {name} of layer {other}'
        outside = bracket == '<' and ('/' in name or name.endswith('.h'))
        if core and outside and not name.startswith(CORE_LIBRARIES + SYSTEM_HEADERS):
            yield f'the core must not include {name}'
    if core:
        for call in FORBIDDEN_CALLS.findall(without_comments(text)):
            yield f'the core must not call {call}'
    if path.suffix == '.hpp' and 'using namespace' in text:
        yield 'no "using namespace" in a header'


def main():
    root, library = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    files = [path for folder in ('include', 'src') for path in sorted((root / folder).rglob('*.?pp'))]
    faults = [f'{path.relative_to(root)}: {fault}' for path in files
              for fault in faults_of(path, root)]
    linked = subprocess.run(['ldd', library], check=True, capture_output=True, text=True).stdout
    faults += [f'libmbncc.so links {line.split()[0]}' for line in linked.splitlines()
               if line.strip().startswith(ROS_LIBRARIES)]
    print('\n'.join(faults) or f'{len(files)} files keep to their layers')
    return 1 if faults or not files else 0


if __name__ == '__main__':
    sys.exit(main())
