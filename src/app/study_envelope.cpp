// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study_kinds.hpp"
#include "app/voice.hpp"
#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/version.hpp"
#include "render/png.hpp"
#include "study/envelope.hpp"
#include "study/envelope_map.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct EnvelopeWords {
  StudyWords study;
  bool quick = false;
  std::vector<std::string> families;
};

void describe_words(CLI::App& kind, EnvelopeWords& words) {
  kind.add_flag("--quick", words.quick, "Only a sample of cells, in well under a minute");
  kind.add_option("--family", words.families, "Families of cells by name (all)")
      ->type_name("NAME,...")
      ->delimiter(',');
  describe_study_options(kind, words.study, "out/study/envelope");
  std::string list;
  for (const EnvelopeFamily& family : envelope_families())
    list += fmt::format("  {:<12} {}\n", family.name, family.sentence);
  kind.footer(
      "Runs scenes at the extremes, each in a program of its own, and draws a map of how they "
      "end:\n"
      "with a right result, which the script of the family checks against a closed form, an\n"
      "invariant or a scaled twin within a derived tolerance; refused before the run; or stopped\n"
      "cleanly with cause, time and place. A nan, a crash, a hang, a wrong result and a ledger of\n"
      "energy that is open by 5 % unsaid fail, and so does an end that the cell does not allow: "
      "exit\n"
      "code 1. The scripts are in scripts/envelope. Families:\n" +
      list);
}

Json json_of(const std::vector<CellResult>& results, bool quick) {
  Json json{{"schema", 1}, {"kind", "envelope"}, {"version", version()}, {"quick", quick}};
  json["counts"] = Json::object();
  for (const CellEnd end : {CellEnd::right, CellEnd::refused, CellEnd::stopped, CellEnd::failed})
    json["counts"][std::string(name_of(end))] = count(results, end);
  json["cells"] = Json::array();
  for (const CellResult& one : results)
    json["cells"].push_back({{"family", one.cell.family},
                             {"name", one.cell.name},
                             {"verdict", name_of(one.verdict.end)},
                             {"why", one.verdict.why},
                             {"seconds", one.seconds}});
  return json;
}

// One row for each cell.
Table table_of(const std::vector<CellResult>& results) {
  Table table{{"family", "cell", "verdict", "why", "seconds"}, {}};
  for (const CellResult& one : results)
    table.rows.push_back({std::string(one.cell.family), one.cell.name,
                          std::string(name_of(one.verdict.end)), one.verdict.why,
                          fmt::format("{:.2f}", one.seconds)});
  return table;
}

void carry_out(const EnvelopeWords& words, const std::vector<std::string>& /*arguments*/) {
  const StudyWords& study = words.study;
  const std::vector<EnvelopeCell> cells = envelope_cells(words.families, words.quick);
  const fs::path folder = study.folder.empty() ? fs::path("out/study/envelope") : study.folder;
  Sharing sharing;
  const auto results = run_envelope(cells,
                                    {.program = this_program(),
                                     .scripts = data_file(fs::path("scripts") / "envelope"),
                                     .runner = runner_options_of(study, folder)},
                                    sharing);
  finish({"envelope", text_map(results), table_of(results), {}}, json_of(results, words.quick),
         study, folder, sharing, [&] {
           write_png(picture_map(results), folder / "envelope.png");
           if (!study.quiet && !study.json) tell_file(folder / "envelope.png");
         });
  if (const std::size_t failed = count(results, CellEnd::failed); failed > 0)
    throw Error(ErrorKind::run_failed,
                fmt::format("{} of {} cells of the envelope fail", failed, results.size()),
                fmt::format("{} tells why", (folder / "envelope.csv").string()));
}

}  // namespace

void describe_study_envelope(CLI::App& study, StudyAction& action) {
  describe_kind<EnvelopeWords>(study, action, "envelope",
                               "Map how scenes at the extremes end: right, refused or stopped",
                               describe_words, carry_out);
}

}  // namespace hackle
