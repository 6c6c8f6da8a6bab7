// SPDX-License-Identifier: MIT
#include "console/prompt/line_reader.hpp"

#include <array>
#include <cerrno>

#include <unistd.h>

namespace hackle {

LineEnd LineReader::read(std::string& line, const Idle& idle) {
  std::size_t end = 0;
  while ((end = buffer_.find('\n', end)) == buffer_.npos) {
    end = buffer_.size();
    if (!wait_for_input(idle, [] {})) return LineEnd::end_of_input;
    if (fill()) continue;
    if (buffer_.empty()) return LineEnd::end_of_input;
    buffer_ += '\n';
  }
  line = buffer_.substr(0, end);
  buffer_.erase(0, end + 1);
  if (line.ends_with('\r')) line.pop_back();
  return LineEnd::entered;
}

// Returns false at the end.
bool LineReader::fill() {
  std::array<char, 4096> some{};
  ssize_t count = 0;
  do count = ::read(STDIN_FILENO, some.data(), some.size());
  while (count < 0 && errno == EINTR);
  if (count > 0) buffer_.append(some.data(), static_cast<std::size_t>(count));
  return count > 0;
}

}  // namespace hackle
