#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the sources for features newer than Ubuntu 20.04, the system of ROS Noetic, according to the change logs of the libraries.

usage: oldest_versions_test.py SOURCE_DIR
"""
import ast
import pathlib
import re
import sys

FOLDERS = ('include', 'src', 'test', 'bench', 'examples', 'scripts', '.ci')

# Features newer than OpenCV 4.2, by version.
OPENCV = {
    '4.3': 'COLORMAP_DEEPGREEN|QRCodeDetector::detectMulti',
    '4.4': 'SIFT|INTER_NEAREST_EXACT|ximgproc::EdgeDrawing|CAP_PROP_BITRATE',
    '4.5': 'UsacParams|USAC_\\w+|SOLVEPNP_SQPNP|imcount|segmentation|IntelligentScissorsMB|'
           'CAP_PROP_HW_\\w+|CAP_PROP_ORIENTATION_\\w+|CAP_PROP_(OPEN|READ)_TIMEOUT_MSEC|haveImageWriter|'
           'COLOR_Bayer(RGGB|BGGR|GRBG|GBRG)\\w+|reduceArg(Max|Min)|HoughLinesWithAccumulator|'
           'parallel::setParallelForBackend|QRCodeEncoder|barcode|Face(DetectorYN|RecognizerSF)|Tracker(DaSiamRPN|Nano)|'
           'calibrateRobotWorldHandEye',
    '4.6': 'divSpectrums|undistortImagePoints|fisheye::solvePnP|aruco::ArucoDetector|LMSolver_create',
    '4.7': 'stackBlur|hasNonZero|findContoursLinkRuns|imdecodemulti|flipND|transposeND|broadcast|'
           'IMWRITE_(AVIF_\\w+|JPEG_SAMPLING_FACTOR\\w*|HDR_\\w+)|v_(add|sub|mul|div|lt|gt|le|ge|eq|ne|and|or|xor|not)|'
           'VTraits|REDUCE_SUM2|blobFromImageWithParams',
    '4.8': 'ImageCollection|IMREAD_COLOR_RGB|phaseCorrelateIterative|getClosestEllipsePoints|THRESH_DRYRUN',
}
PATTERNS = {
    'C++': [('OpenCV ' + version, r'\bcv::(?:\w+::)*(?:%s)\b' % names) for version, names in OPENCV.items()] + [
        ('yaml-cpp 0.7', r'\bYAML::(?:DeepRecursion|DepthGuard|StringSource)\b|yaml-cpp/(?:depthguard|fp_to_string)'),
        ('Eigen 3.4', r'\bEigen::(?:all|last|seq|seqN|indexing|placeholders|(?:Vector|Matrix|RowVector|Array)X)\b|\.reshaped\('),
        ('Boost 1.72 and newer', r'boost/(?:pfr|json|leaf|describe|lambda2|url|mysql|static_string|nowide|stl_interfaces|cobalt|'
                                 r'charconv|redis|scope|unordered/unordered_(?:flat|node|concurrent)|core/span)'),
        ('libstdc++ 10 and newer', r'\bstd::(?:span|jthread|stop_token|latch|barrier|counting_semaphore|format|numbers|bit_cast|'
                                   r'source_location|ranges|to_array|erase_if|ssize|lerp|midpoint|strong_ordering|identity|'
                                   r'remove_cvref\w*|make_shared_for_overwrite|atomic_ref|assume_aligned)\b|'
                                   r'#\s*include\s*<(?:span|concepts|ranges|format|bit|numbers|source_location|compare|coroutine|latch|'
                                   r'barrier|semaphore|stop_token|syncstream|version)>'),
        ('Qt 5.13 and newer', r'\bevent(?:->|\.)(?:position|globalPosition)\(|'
                              r'\bQt::(?:endl|(?:Skip|Keep)EmptyParts|ReturnByValue)\b|'
                              r'\bQComboBox::text(?:Activated|Highlighted)\b|'
                              r'\bQButtonGroup::id(?:Clicked|Pressed|Released|Toggled)\b|\bmoveToTrash\('),
        # Other calls for a double cannot be distinguished from those for an int, which gcc 8 supports.
        ('floating-point charconv of libstdc++ 11', r'\bstd::chars_format\b|'
                                                    r'\bstd::(?:from|to)_chars(?:<\s*(?:float|double)|\([^;]*,\s*-?\d+\.\d*)'),
        ('C++20', r'\b(?:co_await|co_yield|consteval|constinit|char8_t)\b|\brequires\s+[A-Z(]|\btemplate\s*<\s*concept|'
                  r'\.(?:starts_with|ends_with)\(|<=>'),
    ],
    'CMake': [
        ('CMake 3.17 and newer', r'cmake_language|ZIP_LISTS|CMAKE_CURRENT_FUNCTION|cmake_path|REAL_PATH|string\(JSON|file\(ARCHIVE|'
                                 r'file\(CONFIGURE|find_(?:program|library|path|file)\([^)]*\bREQUIRED\b|DEPFILE|'
                                 r'\$<(?:TARGET_RUNTIME_DLLS|COMPILE_ONLY|LIST:|PATH:)|block\(|FILE_SET'),
    ],
    'shell': [('CMake 3.17 and newer', r'ctest [^|\n]*--test-dir|--preset'),
              ('bash 5.1 and newer', r'\$\{\w+@[UuLKk]\}|\bSRANDOM\b|\$\{ ')],
    'Python': [
        ('Python 3.9 and newer', r'\.remove(?:prefix|suffix)\(|\bfunctools\.cache\b|\bmath\.(?:lcm|nextafter|ulp|cbrt|exp2)\b|'
                                 r'\bast\.unparse\b|\bis_relative_to\(|BooleanOptionalAction|\brandbytes\(|\bzoneinfo\b|\bgraphlib\b|'
                                 r'\bbit_count\(|\bpairwise\(|strict=True|\bdatetime\.UTC\b|\btomllib\b|'
                                 r'\bExceptionGroup\b|\badd_note\('),
        ('types that are generic since Python 3.9', r'(?:->|:)\s*(?:list|dict|tuple|set)\['),
    ],
}
# A program that is only built if OpenCV provides SIFT.
EXCEPTED = {'bench/matching/sift_engine.cpp', 'bench/matching/sift_engine.hpp', 'test/oldest_versions_test.py'}

# Code that is compiled for some versions of Qt only.
QT_CHECK = re.compile(r'^#if QT_VERSION\b.*?^#endif', re.MULTILINE | re.DOTALL)


def kind_of(path):
    if path.suffix in ('.cpp', '.hpp', '.inc'):
        return 'C++'
    if path.name == 'CMakeLists.txt' or path.suffix == '.cmake':
        return 'CMake'
    if path.suffix == '.py':
        return 'Python'
    first = path.read_bytes()[:80].split(b'\n')[0]
    if first.startswith(b'#!'):
        return 'Python' if b'python' in first else 'shell'
    return None


def faults_of(kind, text):
    text = QT_CHECK.sub(lambda found: '\n' * found.group().count('\n'), text)
    for newer, pattern in PATTERNS[kind]:
        for found in re.finditer(pattern, text, re.MULTILINE):
            yield '%d: %s is of %s' % (text.count('\n', 0, found.start()) + 1, found.group().strip(), newer)
    if kind == 'Python':
        try:
            ast.parse(text, feature_version=(3, 8))
        except SyntaxError as error:
            yield '%s: %s is no Python 3.8' % (error.lineno, error.msg)


def check_itself():
    """A pattern that matches nothing would always pass."""
    newer = {'C++': ['cv::SIFT::create()', 'cv::stackBlur(', 'YAML::DeepRecursion', 'Eigen::seq(', '<boost/json.hpp>', 'std::span<int>',
                     '#include <bit>', 'std::from_chars(a, b, value, std::chars_format::general)', 'std::to_chars(a, b, 0.5)',
                     'name.starts_with("a")', 'co_await x', 'event->position()', 'Qt::endl'],
             'CMake': ['cmake_path(', 'find_program(X x REQUIRED)'], 'shell': ['ctest --test-dir build', '${name@U}'],
             'Python': ['a.removeprefix("b")', 'def f(x: list[int]): pass', 'match x:\n  case 1: pass',
                        'with (open(a) as b, open(c) as d): pass']}
    faults = ['the pattern for %r finds nothing' % text for kind, texts in newer.items() for text in texts
              if not list(faults_of(kind, text))]
    checked = '#if QT_VERSION >= QT_VERSION_CHECK(5, 14, 0)\nevent.position();\n#endif\n'
    if list(faults_of('C++', checked)) or not list(faults_of('C++', checked + 'event.position();')):
        faults.append('a version check does not exempt exactly the code within it')
    return faults


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    files = [path for folder in FOLDERS for path in sorted((root / folder).rglob('*')) if path.is_file()]
    files.append(root / 'CMakeLists.txt')
    checked, faults = 0, check_itself()
    for path in files:
        name = path.relative_to(root).as_posix()
        kind = kind_of(path)
        if kind is None or name in EXCEPTED:
            continue
        checked += 1
        faults += ['%s:%s' % (name, fault) for fault in faults_of(kind, path.read_text())]
    print('\n'.join(faults) or '%d files keep to Ubuntu 20.04' % checked)
    return 1 if faults or checked < 100 else 0


if __name__ == '__main__':
    sys.exit(main())
