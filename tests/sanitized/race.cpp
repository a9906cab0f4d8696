// Two threads and one number: with a race, or guarded by what OpenMP offers and the engine uses.
#include <cstdio>

int main(int count, char**) {
    const bool guarded = count > 1;
    constexpr int n = 10000;
    long sum = 0, reduced = 0;
    long shared[n];
#pragma omp parallel num_threads(2)
    {
#pragma omp for schedule(static)
        for (int i = 0; i < n; ++i) shared[i] = i;
#pragma omp for schedule(dynamic, 4) reduction(+ : reduced)
        for (int i = 0; i < n; ++i) reduced += shared[n - 1 - i];  // written by the other thread, before the barrier
        if (guarded) {
#pragma omp single
            sum += reduced;
        } else {
            // Many places: of one that both write at the very same moment, the sanitizer may see nothing.
            for (long& number : shared) ++number;
        }
    }
    std::printf("%ld %ld\n", sum, reduced);
    return 0;
}
