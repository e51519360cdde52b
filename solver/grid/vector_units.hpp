#pragma once
// Function attribute: compiles the function for AVX-512, for AVX2 and for any x86-64 processor; the loader
// picks the widest version that the processor can run. So one binary runs on every x86-64 machine. Only loops
// that the compiler vectorises become faster. The macro is empty with clang 14, which does not support the
// attribute on templates.
#ifdef __clang__
#define CAPSTAN_VECTOR_UNITS
#else
#define CAPSTAN_VECTOR_UNITS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
