#pragma once
// One binary for every machine: the loader takes the clone of a function that fits the processor's vector
// registers (AVX-512, AVX2, or the least that every x86-64 has). The loops inside must be ones that the
// compiler vectorises.
// Not with clang 14, which has no clones of templates: there everything is compiled for every x86-64.
#ifdef __clang__
#define CAPSTAN_VECTOR_UNITS
#else
#define CAPSTAN_VECTOR_UNITS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
