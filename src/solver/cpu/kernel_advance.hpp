// SPDX-License-Identifier: MIT
// The kernels of each instruction set, and what they call back.
#pragma once

#include <vector>

#include "solver/cpu/kernel.hpp"

namespace hackle {

void note_broken_bond(std::vector<BrokenBond>& broken_bonds, const BrokenBond& broken);

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
