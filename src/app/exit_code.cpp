// SPDX-License-Identifier: MIT
#include "app/exit_code.hpp"

#include <array>
#include <exception>
#include <new>

#include "app/voice.hpp"

namespace hackle {
namespace {

constexpr std::array codes{
    ExitCode{0, "All went well"},
    ExitCode{1,
             "The run failed: it diverged, ran out of memory, or a movie could not be encoded; "
             "or hackle diff found a difference, or hackle validate a check that fails"},
    ExitCode{2, "The command line makes no sense"},
    ExitCode{3, "There is an error in the script"},
    ExitCode{4, "Input was refused: it makes no physical or numerical sense"},
    ExitCode{5, "A file could not be read or written, or output was lost"},
    ExitCode{130, "Interrupted with Ctrl-C"},
};

}  // namespace

std::span<const ExitCode> exit_codes() {
  return codes;
}

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
