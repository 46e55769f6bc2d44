// Includes the file that RELIEVO_KERNEL names once for each generation of processors (processor.h),
// in the namespaces relievo::preprocess::baseline, avx2 and avx512. The kernel's own includes must
// come before. No include guard: a source file includes this once for each of its kernels.
//
// RELIEVO_KERNEL_AVX512 says whether the form at hand may use that generation's instructions by
// name: the compiler's own macros do not, g++ 12 sets them by options of its command line alone.

#define RELIEVO_KERNEL_AVX512 0
namespace relievo::preprocess::baseline {
#include RELIEVO_KERNEL
}

#if RELIEVO_SEVERAL_PROCESSORS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace relievo::preprocess::avx2 {
#include RELIEVO_KERNEL
}
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx2,avx512f,avx512dq,avx512bw,avx512vl")
#undef RELIEVO_KERNEL_AVX512
#define RELIEVO_KERNEL_AVX512 1
namespace relievo::preprocess::avx512 {
#include RELIEVO_KERNEL
}
#pragma GCC pop_options
#endif
#undef RELIEVO_KERNEL_AVX512
