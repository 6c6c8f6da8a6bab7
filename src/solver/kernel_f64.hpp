// SPDX-License-Identifier: MIT
// The exact kernel in double precision, one instance for each instruction set.
#pragma once

#include "solver/kernel.hpp"

namespace hackle {

namespace baseline {
ForceKernel kernel_f64(bool guarded);
}
namespace avx2 {
ForceKernel kernel_f64(bool guarded);
}
namespace avx512 {
ForceKernel kernel_f64(bool guarded);
}

}  // namespace hackle
