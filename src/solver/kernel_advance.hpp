// SPDX-License-Identifier: MIT
// The kernels of each instruction set, and what they call back.
#pragma once

#include <vector>

#include "solver/kernel.hpp"

namespace hackle {

void note_loss(std::vector<Loss>& losses, const Loss& loss);

namespace baseline {
template <class Real>
Kernel<Real> kernel(KernelFeatures features);
}
namespace baseline_fused {
template <class Real>
Kernel<Real> kernel(KernelFeatures features);
}
namespace avx2 {
template <class Real>
Kernel<Real> kernel(KernelFeatures features);
}
namespace avx2_fused {
template <class Real>
Kernel<Real> kernel(KernelFeatures features);
}
namespace avx512 {
template <class Real>
Kernel<Real> kernel(KernelFeatures features);
}
namespace avx512_fused {
template <class Real>
Kernel<Real> kernel(KernelFeatures features);
}

}  // namespace hackle
