// SPDX-License-Identifier: MIT
#include "fuzz/script_runner.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "base/interrupt.hpp"
#include "console/console.hpp"

namespace hackle::test {
namespace {

using std::chrono::seconds;

// Interrupts slow work, until it is destroyed.
class Watchdog {
 public:
  explicit Watchdog(const std::string& script) : script_(script), thread_([this] { watch(); }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    changed_.notify_one();
    thread_.join();
    clear_interrupt();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void watch() {
    std::unique_lock lock(mutex_);
    if (changed_.wait_for(lock, seconds(1), [this] { return done_; })) return;
    request_interrupt();
    if (changed_.wait_for(lock, seconds(60), [this] { return done_; })) return;
    std::fprintf(stderr, "this script cannot be interrupted:\n%s\n", script_.c_str());
    std::abort();
  }

  const std::string& script_;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;  // declared last: it uses all of the above
};

}  // namespace

void run_fuzzed(const std::string& script, const std::filesystem::path& folder) {
  ConsoleSettings settings;
  settings.output_folder = folder;
  settings.talk = Talk::quiet;
  settings.execution.threads = 1;
  settings.lua_memory = std::size_t{32} << 20U;
  settings.output_limit = 1e7;
  const Watchdog watchdog(script);
  try {
    Console console(settings);
    console.run_text(script, "fuzz.lua");
  } catch (const Error&) {
  }
}

}  // namespace hackle::test
