// SPDX-License-Identifier: MIT
// Runs a ready-made scene through the console as its user would, and records its events.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "console/scripts.hpp"

namespace hackle::test {

inline constexpr double us = 1e-6, mm = 1e-3;

// A watcher between s:run and the simulation divides the run into intervals, which changes no bit
// of it, and records events after each. Movies and run files are left out; pictures are painted. In
// Lua, `runs[k]` is the k-th simulation: s, first (time of the first broken bond), fork,
// fork_place, joined (time of the second fragment); nil if there was none. `printed` holds the
// output of the script.
inline const std::string watcher = R"(
interval, runs, printed = 0.5*us, {}, ""
local simulate_really, really = simulate, {}
function print(...)
  for _, value in ipairs { ... } do printed = printed .. tostring(value) .. "\n" end
end
local function watch(run)
  local s = run.s
  if not run.first and s.damage.broken_bonds > 0 then run.first = s.time end
  if not run.fork then
    local found = s:cracks()
    if found.fork then run.fork, run.fork_place = s.time, found.fork end
  end
  if run.log then run.log(s) end
end
function simulate(p, options)
  local run = { s = simulate_really(p, options), log = log }
  runs[#runs + 1] = run
  local s = run.s
  local watched = { movie = function() end, record = function() end }
  function watched:run(duration)
    local stop = s.time + duration
    while s.time < stop do
      s:run(math.min(interval, stop - s.time))
      watch(run)
    end
  end
  really[watched] = s
  return setmetatable(watched, { __index = function(_, name)
    local value = s[name]
    if type(value) ~= "function" then return value end
    return function(_, ...) return value(s, ...) end
  end })
end
local chart_really = chart
function chart(options)
  for k, one in ipairs(options.of) do options.of[k] = really[one] or one end
  chart_really(options)
end
)";

class WatchedScript {
 public:
  // `before` is Lua code that may set `interval`, and `log`, a function of the simulation that is
  // called after each interval.
  explicit WatchedScript(const std::string& name, std::map<std::string, std::string> overrides = {},
                         const std::string& before = "")
      : console_(settings(folder_.path, std::move(overrides))) {
    console_.evaluate(watcher);
    if (!before.empty()) console_.evaluate(before);
    console_.run_file(std::filesystem::path(HACKLE_SOURCE_FOLDER) / "scripts" / name);
  }

  // Returns the value of a numerical Lua expression; NaN for nil.
  double operator()(const std::string& expression) {
    return std::stod(console_.evaluate("(" + expression + ") or 0/0").at(0));
  }
  bool holds(const std::string& expression) {
    return console_.evaluate("not not (" + expression + ")").at(0) == "true";
  }
  std::string hash() { return console_.evaluate("runs[1].s.hash").at(0); }
  // Counts the columns of nodes 0.5 mm apart, from `first` to `last` (m), that no crack of the
  // first simulation meets.
  int columns_without_crack(double first, double last) {
    int count = 0;
    for (double x = first; x <= last + 1e-6; x += 0.5e-3)
      count += (*this)("runs[1].s:cracks { from = {" + std::to_string(x - 1e-4) + ", 0}, to = {" +
                       std::to_string(x + 1e-4) + ", 1} }.nodes") == 0.0
                   ? 1
                   : 0;
    return count;
  }
  std::string printed() { return console_.evaluate("printed").at(0); }
  std::size_t pictures() const {
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder_.path))
      count += file.path().extension() == ".png" && file.file_size() > 1000 ? 1 : 0;
    return count;
  }

 private:
  static ConsoleSettings settings(const std::filesystem::path& folder,
                                  std::map<std::string, std::string> overrides) {
    ConsoleSettings settings = quiet(folder);
    settings.overrides = std::move(overrides);
    return settings;
  }

  Folder folder_;
  Console console_;
};

}  // namespace hackle::test
