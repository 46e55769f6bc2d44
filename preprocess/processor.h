#pragma once

#include <algorithm>
#include <atomic>

// Several generations of processors are compiled for where the compiler can do it function by
// function; everywhere else there is only the baseline.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RELIEVO_SEVERAL_PROCESSORS 1
#else
#define RELIEVO_SEVERAL_PROCESSORS 0
#endif

namespace relievo::preprocess {

/// Generations of processors with ever wider vectors. The bits of results are the same with all:
/// products are never fused with sums (CMakeLists.txt).
enum class Processor { Baseline, Avx2, Avx512 };

/// The newest generation that this machine's processor belongs to.
inline Processor newestProcessor() noexcept {
#if RELIEVO_SEVERAL_PROCESSORS
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return Processor::Avx512;
    if (__builtin_cpu_supports("avx2"))
        return Processor::Avx2;
#endif
    return Processor::Baseline;
}

/// While it lives, no newer generation is used: for comparisons between them.
class ProcessorLimit {
  public:
    explicit ProcessorLimit(Processor newest) noexcept : before_(limit().exchange(newest)) {}
    ~ProcessorLimit() { limit() = before_; }
    ProcessorLimit(const ProcessorLimit&) = delete;
    ProcessorLimit& operator=(const ProcessorLimit&) = delete;

    static std::atomic<Processor>& limit() noexcept {
        static std::atomic<Processor> newest = Processor::Avx512;
        return newest;
    }

  private:
    Processor before_;
};

/// The generation to use.
inline Processor thisProcessor() noexcept {
    return std::min(newestProcessor(), ProcessorLimit::limit().load(std::memory_order_relaxed));
}

/// Calls the form of a kernel's function (for_each_processor.h) for this machine.
#if RELIEVO_SEVERAL_PROCESSORS
#define RELIEVO_CALL_KERNEL(function, ...)                                \
    (thisProcessor() == Processor::Avx512 ? avx512::function(__VA_ARGS__) \
     : thisProcessor() == Processor::Avx2 ? avx2::function(__VA_ARGS__)   \
                                          : baseline::function(__VA_ARGS__))
#else
#define RELIEVO_CALL_KERNEL(function, ...) baseline::function(__VA_ARGS__)
#endif

}  // namespace relievo::preprocess
