// SPDX-License-Identifier: MIT
// hackle study in several processes that share one folder: ranks, tasks of a job array, terminals.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <memory>
#include <sstream>
#include <thread>

#include "app/study_plate.hpp"
#include "study/case_claim.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Json = nlohmann::json;
using Words = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

// One of several programs that run side by side.
class Member {
 public:
  Member(const fs::path& folder, const std::string& name, const Words& words,
         const Environment& environment = {}, const char* program = HACKLE_PROGRAM)
      : out_(folder / (name + ".out")), err_(folder / (name + ".err")) {
    std::vector<char*> arguments{const_cast<char*>(program)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ != 0) return;
    for (const auto& [key, value] : environment) setenv(key.c_str(), value.c_str(), 1);
    if (chdir(folder.c_str()) != 0) _exit(99);
    dup2(open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(98);
  }
  ~Member() {
    if (id_ > 0) signal(SIGKILL), wait();
  }
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;

  pid_t id() const { return id_; }
  void signal(int number) const { kill(id_, number); }
  test::Ended wait() {
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = -1;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, test::Program::text_of(out_), test::Program::text_of(err_)};
  }

 private:
  fs::path out_, err_;
  pid_t id_ = -1;
};

class StudyFarmTest : public test::StudiedPlate {
 protected:
  // Every run of the script leaves a line in the folder of its case.
  StudyFarmTest() {
    write_text(folder_.path / "a.lua",
               std::string(test::small_plate) + "\nio.open('ran.txt', 'a'):write('run\\n')\n");
  }

  static Words sweep_into(const std::string& folder) {
    return {"study", "sweep", "a.lua", "-o", folder, "-j", "1", "--set", "load=6:12:1MPa"};
  }
  std::vector<std::unique_ptr<Member>> started(const std::vector<Environment>& environments,
                                               const Words& words,
                                               const char* program = HACKLE_PROGRAM) const {
    std::vector<std::unique_ptr<Member>> members;
    for (std::size_t k = 0; k < environments.size(); ++k)
      members.push_back(std::make_unique<Member>(folder_.path, "member" + std::to_string(k), words,
                                                 environments[k], program));
    return members;
  }
  static std::vector<test::Ended> ended(std::vector<std::unique_ptr<Member>>& members) {
    std::vector<test::Ended> all;
    for (auto& member : members) all.push_back(member->wait());
    return all;
  }

  // How often each case has been run.
  std::vector<long> runs_of_cases(const std::string& folder) const {
    std::vector<long> runs;
    for (const auto& entry : fs::directory_iterator(folder_.path / folder / "cases"))
      if (entry.is_directory()) {
        const std::string log = test::Program::text_of(entry.path() / "ran.txt");
        runs.push_back(std::ranges::count(log, '\n'));
      }
    return runs;
  }
  std::vector<fs::path> locks_in(const std::string& folder) const {
    std::vector<fs::path> locks;
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path / folder, ignored))
      if (entry.path().extension() == ".lock") locks.push_back(entry.path());
    return locks;
  }

  // The results, without times and who ran what.
  Json results_in(const std::string& folder) const {
    Json json = Json::parse(read_text(folder_.path / folder / "sweep.json"));
    json.erase("sharing");
    for (Json& run : json["runs"])
      for (const char* key : {"wall_s", "cpu_s"}) run.erase(key);
    return json;
  }
  std::string table_in(const std::string& folder) const {
    std::istringstream lines(read_text(folder_.path / folder / "sweep.csv"));
    std::string table;
    for (std::string line; std::getline(lines, line); table += line + "\n")
      for (int column = 0; column < 3; ++column)
        line.resize(std::min(line.rfind(','), line.size()));
    return table;
  }

  // Stops the member while it runs a case whose outcome is not there yet.
  bool is_caught(const Member& member) const {
    for (const fs::path& lock : locks_in("out")) {
      const auto holder = holder_in(lock);
      if (!holder || holder->process != member.id()) continue;
      member.signal(SIGSTOP);
      const auto still = holder_in(lock);
      fs::path outcome = lock;
      if (still && still->process == member.id() && !fs::exists(outcome.replace_extension(".json")))
        return true;
      member.signal(SIGCONT);
    }
    return false;
  }
};

Environment rank(int k, int count) {
  return {{"OMPI_COMM_WORLD_RANK", std::to_string(k)},
          {"OMPI_COMM_WORLD_SIZE", std::to_string(count)},
          {"OMPI_COMM_WORLD_LOCAL_SIZE", std::to_string(count)},
          {"PMIX_NAMESPACE", "4711"}};
}

Environment task(int k, int count) {
  return {{"SLURM_ARRAY_TASK_ID", std::to_string(k)},
          {"SLURM_ARRAY_TASK_COUNT", std::to_string(count)},
          {"SLURM_ARRAY_JOB_ID", "812"},
          {"SLURM_CPUS_PER_TASK", "1"},
          {"HACKLE", HACKLE_PROGRAM}};
}

// The words for bash that submit a sweep as a job array.
Words array_of(Words sweep) {
  sweep.erase(sweep.begin(), sweep.begin() + 2);
  const auto threads = std::ranges::find(sweep, "-j");  // which the script gives
  sweep.erase(threads, threads + 2);
  sweep.insert(sweep.begin(), HACKLE_SOURCE_FOLDER "/scripts/cluster/sweep_array.slurm");
  return sweep;
}

TEST_F(StudyFarmTest, RanksRunEveryCaseOnceAndFindWhatOneProcessFinds) {
  ASSERT_EQ(program_.run(sweep_into("alone")).code, 0);
  auto ranks = started({rank(0, 3), rank(1, 3), rank(2, 3)}, sweep_into("out"));
  const auto all = ended(ranks);
  for (const test::Ended& one : all) EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(runs_of_cases("out"), std::vector<long>(7, 1));
  EXPECT_EQ(results_in("out"), results_in("alone"));
  EXPECT_EQ(table_in("out"), table_in("alone"));
  EXPECT_TRUE(locks_in("out").empty());
  EXPECT_THAT(all[0].out, HasSubstr(" processes on 1 machine ("));
  for (const int silent : {1, 2}) EXPECT_EQ(all[silent].out + all[silent].err, "");
}

TEST_F(StudyFarmTest, ARunOfAKilledProcessIsTakenOver) {
  auto terminals = started({{}, {}, {}}, sweep_into("out"));
  const Member& victim = *terminals[2];
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!is_caught(victim) && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  victim.signal(SIGKILL);
  const auto all = ended(terminals);
  EXPECT_EQ(all[2].code, 128 + SIGKILL);
  for (const int living : {0, 1}) {
    EXPECT_EQ(all[living].code, 0) << all[living].err;
    EXPECT_THAT(all[living].out, HasSubstr("1 run taken over"));
  }
  EXPECT_THAT(all[0].err + all[1].err, HasSubstr("ended while it ran load "));
  EXPECT_EQ(runs_of_cases("out").size(), 7U);
  EXPECT_TRUE(locks_in("out").empty());
}

TEST_F(StudyFarmTest, OneTaskOfAJobArrayWritesTheReport) {
  auto tasks =
      started({task(4, 3), task(5, 3), task(6, 3)}, array_of(sweep_into("out")), "/bin/bash");
  const auto all = ended(tasks);
  int reports = 0;
  for (const test::Ended& one : all) {
    EXPECT_EQ(one.code, 0) << one.err;
    reports += !one.out.empty();
    if (one.out.empty()) {
      EXPECT_THAT(one.err, HasSubstr("the report of the array is in out"));
    }
  }
  EXPECT_EQ(reports, 1);
  EXPECT_EQ(runs_of_cases("out"), std::vector<long>(7, 1));
  const test::Ended late = Member(folder_.path, "late", sweep_into("out"), task(7, 4)).wait();
  EXPECT_EQ(late.code, 0);
  EXPECT_EQ(late.out, "");
}

TEST_F(StudyFarmTest, JobScriptsAreScripts) {
  const Words names{"sweep_array", "sweep_mpi", "run_mpi"};
  for (const std::string& name : names) {
    const std::string script = HACKLE_SOURCE_FOLDER "/scripts/cluster/" + name + ".slurm";
    EXPECT_EQ(Member(folder_.path, name, {"-n", script}, {}, "/bin/bash").wait().code, 0) << name;
  }
}

TEST_F(StudyFarmTest, WhatAllRanksMeetIsToldOnce) {
  write_text(folder_.path / "a.lua", "plat {}");
  auto ranks = started({rank(0, 2), rank(1, 2)}, sweep_into("out"));
  const auto all = ended(ranks);
  EXPECT_NE(all[0].code, 0);
  EXPECT_THAT(all[0].err, HasSubstr("plat"));
  EXPECT_NE(all[1].code, 0);
}

}  // namespace
}  // namespace hackle
