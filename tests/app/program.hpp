// SPDX-License-Identifier: MIT
// Runs the program itself in a separate folder.
#pragma once

#include <cerrno>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "console/scripts.hpp"

namespace hackle::test {

struct Ended {
  int code = -1;  // 128 + the number of the signal that ended it
  std::string out, err;
};

class Program {
 public:
  explicit Program(const Folder& folder) : folder_(folder.path) {}

  // Called once with the process id, when the program has written something to stdout.
  std::function<void(pid_t)> at_first_word;
  std::string input;  // its stdin

  Ended run(const std::vector<std::string>& words) const {
    int ends[2];
    if (pipe(ends) != 0) return {};
    std::ofstream(folder_ / ".input") << input;
    const pid_t child = fork();
    if (child == 0) become(words, ends);
    close(ends[1]);
    Ended ended;
    ended.out = read_all(ends[0], child);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ended.err = text_of(folder_ / ".errors");
    return ended;
  }

  static std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  [[noreturn]] void become(const std::vector<std::string>& words, const int (&ends)[2]) const {
    std::vector<char*> arguments{const_cast<char*>(HACKLE_PROGRAM)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (chdir(folder_.c_str()) != 0) _exit(99);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    dup2(open(".input", O_RDONLY), STDIN_FILENO);
    dup2(open(".errors", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(98);
  }

  std::string read_all(int end, pid_t child) const {
    std::string text;
    char block[4096];
    for (;;) {
      const ssize_t count = read(end, block, sizeof block);
      if (count <= 0) return text;
      if (text.empty() && at_first_word) at_first_word(child);
      text.append(block, static_cast<std::size_t>(count));
    }
  }

  std::filesystem::path folder_;
};

// Returns whether the boxes of an MP4 fill the file to its end and one of them is the index.
inline bool is_whole_mp4(const std::filesystem::path& path) {
  const std::string bytes = Program::text_of(path);
  bool index = false;
  std::size_t at = 0;
  while (at + 8 <= bytes.size()) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i)
      size = size * 256 + static_cast<unsigned char>(bytes[at + i]);
    index = index || bytes.compare(at + 4, 4, "moov") == 0;
    if (size < 8) return false;
    at += size;
  }
  return index && at == bytes.size();
}

}  // namespace hackle::test
