// SPDX-License-Identifier: MIT
#include "app/exit_code.hpp"

#include <exception>
#include <new>

#include "app/voice.hpp"

namespace hackle {

int exit_code_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const Error& error) {
    tell(error);
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    tell(Error(ErrorKind::run_failed, "out of memory", "a coarser spacing needs less"));
  } catch (const std::exception& error) {
    tell(Error(ErrorKind::run_failed, error.what()));
  }
  return static_cast<int>(ErrorKind::run_failed);
}

}  // namespace hackle
