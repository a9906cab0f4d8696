// Functions built for several x86-64 levels, of which the program takes the best when it starts.
#pragma once

// For function templates in an unnamed namespace, whose clones cannot be merged with those of another file. Sanitizers
// do not support the mechanism, and other compilers and processors get the plain build.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && defined(__OPTIMIZE__)
#define SLUICE_ISA_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"), gnu::flatten]]
#else
#define SLUICE_ISA_CLONES
#endif
