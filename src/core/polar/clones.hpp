// Functions compiled once per instruction set; the loader picks the version the machine has.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MBNCC_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define MBNCC_CLONES
#endif
