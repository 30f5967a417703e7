// SPDX-License-Identifier: BSD-3-Clause
// Functions compiled once per instruction set; the loader selects the version that the machine
// supports.
#pragma once

// The loader selects the version before the sanitizer is initialised, so sanitized builds have only
// one version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MBNCC_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define MBNCC_CLONES
#endif
