// SPDX-License-Identifier: MIT
#include "app/company.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/ranks/launcher.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;

// How long a rank that failed waits for others that may have failed alike, s. The first may be
// completing its files.
constexpr double patience_of_first = 5.0, patience_of_others = 60.0;
constexpr double for_ever = 1e9;

fs::path make_temporary_folder() {
  std::string name = (fs::temp_directory_path() / "hackle_rank_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw Error(ErrorKind::files,
                fmt::format("no folder can be made in '{}'", fs::temp_directory_path().string()),
                "set TMPDIR to one where it can");
  return name;
}

std::string tail_of(int descriptor) {
  std::array<char, 2000> text{};
  const off_t size = lseek(descriptor, 0, SEEK_END);
  const off_t from = std::max<off_t>(size - static_cast<off_t>(text.size()), 0);
  const ssize_t count = pread(descriptor, text.data(), text.size(), from);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

}  // namespace

Company::Company(Ranks* ranks) : ranks_(ranks) {
  if (!follows()) return;
  folder_ = make_temporary_folder();
  said_ = open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(said_ >= 0 ? said_ : nowhere, STDERR_FILENO);
  close(nowhere);
}

Company::~Company() {
  remove_folder();
}

void Company::remove_folder() const {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

void Company::join(ConsoleSettings& settings) const {
  settings.execution.ranks = ranks_;
  if (ranks_ != nullptr && settings.execution.threads == 0)
    settings.execution.threads = share_of_cores(this_launcher());
  if (!follows()) return;
  settings.output_folder = folder_;
  settings.force = true;
  settings.talk = Talk::quiet;
  settings.only_verdicts = settings.no_pictures = true;
  settings.show_in_terminal = false;
  settings.last_picture.clear();
  settings.sample_at.reset();
  if (settings.checkpoint_every > 0.0) settings.checkpoint_every = for_ever;
}

int Company::leave(int code) const {
  if (ranks_ == nullptr) return code;
  const double failed = ranks_->leads() ? patience_of_first : patience_of_others;
  if (ranks_->meet(code == 0 ? for_ever : failed)) return code;
  const std::string said = said_ >= 0 ? tail_of(said_) : "";
  remove_folder();
  ranks_->end_all(code, fmt::format("{}hackle: error: rank {} has ended, while others went on\n",
                                    said, ranks_->rank()));
  return code;
}

}  // namespace hackle
