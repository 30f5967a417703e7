#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the layers: a file includes only its own layer or lower ones, the core does not use ROS,
and its private code is in the namespace of its folder.

usage: layers_test.py SOURCE_DIR LIBMBNCC
"""
import pathlib
import re
import subprocess
import sys

# All source folders with their levels: a file may include its own folder and lower ones.
FOLDERS = {
    'base': 0,
    'numeric': 1, 'simd': 1,
    'imaging': 2,
    'matching/polar': 3, 'library': 3,
    'matching/scene': 4,
    'matching/template': 5,
    'matching/proposal': 6, 'matching/evidence': 6,
    'matching/refinement': 7,
    'matching/decision': 8, 'matching/prepared': 8,
    'matching/search': 10,
    'matching': 11, 'matching/explanation': 12,
    'learning/alignment': 13,
    'learning/change': 14,
    'learning/likelihood': 15,
    'learning/segmentation': 16,
    'learning/quality': 17,
    'learning/teaching': 18,
    'miss': 18,
    'cell/capture': 19, 'cell/incremental_search': 19, 'cell/projection': 19, 'cell/tracking': 19,
    'sim': 19,
    'nodelets': 21, 'cli': 21, 'console': 21,
}
NODELETS = 21
# The private code of a core folder is in mbncc::<last part of its name>, except in these folders.
NAMESPACES = {'base': 'mbncc', 'matching': 'mbncc', 'miss': 'mbncc', 'simd': 'mbncc::kernels',
              'matching/template': 'mbncc::templates'}
# LibraryCache is declared in a public header; clones.hpp only defines macros.
NAMESPACE_OF_FILE = {'library_cache.hpp': 'mbncc', 'library_cache.cpp': 'mbncc', 'clones.hpp': None}
# Public headers lie in one folder per layer. Those without an implementation hold data: the layer's private folders
# and all above may include them. The others have the level of the folder that implements them.
PUBLIC = {'matching': 3, 'learning': 13, 'cell': 19}
CORE_LIBRARIES = ('opencv2/core', 'opencv2/imgproc', 'opencv2/ximgproc', 'Eigen/', 'jpeglib.h', 'png.h',
                  'yaml-cpp/')
SYSTEM_HEADERS = ('sys/', 'unistd.h', 'fcntl.h', 'dirent.h', 'immintrin.h')
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
NAMESPACE = re.compile(r'^namespace (mbncc[\w:]*) {', re.MULTILINE)
FORBIDDEN_CALLS = re.compile(r'\b(std::cout|std::cerr|std::clog|printf\s*\(|puts\s*\(|abort\s*\(|'
                             r'exit\s*\()')
ROS_LIBRARIES = ('libros', 'libtf', 'libnodelet', 'libcv_bridge', 'libimage_transport',
                 'libactionlib', 'libclass_loader', 'libxmlrpcpp')


def folder_of(parts):
    """The folder in FOLDERS that contains the file with these path components; None if there is none."""
    for length in (2, 1):
        name = '/'.join(parts[:length])
        if len(parts) > length and name in FOLDERS:
            return name
    return None


def folder_of_file(path, root):
    parts = path.relative_to(root).parts
    if parts[:2] == ('src', 'core'):
        return folder_of(parts[2:])
    if parts[0] == 'src':
        return folder_of(parts[1:])
    if parts[:2] == ('include', 'mbncc'):
        return folder_of_header('/'.join(parts[1:]))
    return None


def folder_of_header(name):
    """Folder of "mbncc/..." or of a private header, None for other libraries."""
    parts = name.split('/')
    if parts[0] != 'mbncc':
        return folder_of(parts)
    return parts[1] if len(parts) > 2 and (parts[1] in FOLDERS or parts[1] in PUBLIC) else 'base'


def first_own_header(path):
    quoted = [name for bracket, name in INCLUDE.findall(path.read_text()) if bracket == '"']
    return quoted[0] if quoted else ''


class PublicHeaders:
    """The level of each header in include/."""

    def __init__(self, root):
        self.implemented = {}
        for path in (root / 'src/core').rglob('*.cpp'):
            header, folder = first_own_header(path), folder_of_file(path, root)
            if header.startswith('mbncc/') and path.stem == pathlib.Path(header).stem and folder:
                self.implemented[header] = FOLDERS[folder]

    def height_of(self, name):
        folder = folder_of_header(name)
        if name in self.implemented or not name.startswith('mbncc/'):
            return self.implemented.get(name, FOLDERS.get(folder))
        return PUBLIC.get(folder, FOLDERS.get(folder))


def without_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', '', text, flags=re.DOTALL)


def namespace_of(path, root, folder):
    """Namespace of a file of src/core; a .cpp that implements a public header has the header's."""
    own = NAMESPACES.get(folder, 'mbncc::' + folder.split('/')[-1])
    if path.suffix == '.cpp':
        header = first_own_header(path)
        if header.startswith('mbncc/'):
            own = NAMESPACE.search((root / 'include' / header).read_text()).group(1)
    return NAMESPACE_OF_FILE.get(path.name, own)


def faults_of(path, root, headers):
    own = folder_of_file(path, root)
    if own is None:
        yield 'stands in no folder that this test knows'
        return
    public = 'include' in path.relative_to(root).parts
    height = headers.height_of(str(path.relative_to(root / 'include'))) if public else FOLDERS[own]
    text = path.read_text()
    core = height < NODELETS
    for bracket, name in INCLUDE.findall(text):
        outside = bracket == '<' and ('/' in name or name.endswith('.h'))
        if core and outside and not name.startswith(CORE_LIBRARIES + SYSTEM_HEADERS):
            yield f'the core must not include {name}'
        if bracket != '"' and not name.startswith('mbncc'):
            other = None
        else:
            other = folder_of_header(name)
        if other is None or other == own:
            continue
        allowed = height if name.startswith('mbncc/') else height - 1
        if headers.height_of(name) > allowed:
            yield f'{own} must not include {name} of {other}'
    if core:
        for call in FORBIDDEN_CALLS.findall(without_comments(text)):
            yield f'the core must not call {call}'
    if core and not public:
        expected, opened = namespace_of(path, root, own), NAMESPACE.findall(text)
        if path.suffix == '.cpp':
            opened = opened[:1]
        if set(opened) != {expected} - {None}:
            yield f'opens {" and ".join(opened) or "no namespace"} instead of {expected}'
    if path.suffix == '.hpp' and 'using namespace' in text:
        yield 'no "using namespace" in a header'


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    root, library = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    files = [path for folder in ('include', 'src') for path in sorted((root / folder).rglob('*.?pp'))]
    headers = PublicHeaders(root)
    faults = [f'{path.relative_to(root)}: {fault}' for path in files
              for fault in faults_of(path, root, headers)]
    listed = (root / 'docs/architecture.md').read_text()
    faults += [f'docs/architecture.md does not tell of {folder}' for folder, height in FOLDERS.items()
               if f"| `src/{'' if height == NODELETS else 'core/'}{folder}` |" not in listed]
    linked = subprocess.run(['ldd', library], check=True, capture_output=True, text=True).stdout
    faults += [f'libmbncc.so links {line.split()[0]}' for line in linked.splitlines()
               if line.strip().startswith(ROS_LIBRARIES)]
    print('\n'.join(faults) or f'{len(files)} files keep to their layers')
    return 1 if faults or not files else 0


if __name__ == '__main__':
    sys.exit(main())
