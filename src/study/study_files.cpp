// SPDX-License-Identifier: MIT
#include "study/study_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "output/chart/chart.hpp"
#include "study/case_claim.hpp"

namespace hackle {

std::string findings_text(const nlohmann::ordered_json& json) {
  return json.dump(1) + "\n";
}

std::vector<std::filesystem::path> write_findings(const StudyFindings& findings,
                                                  const nlohmann::ordered_json& json,
                                                  const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files{folder / (findings.name + ".csv"),
                                           folder / (findings.name + ".json")};
  const CaseClaim turn = CaseClaim::in_turn(folder / ".findings.lock");
  write_text(files[0], csv_of(findings.table));
  for (std::size_t k = 0; k < findings.diagrams.size(); ++k) {
    const std::string number = k == 0 ? "" : fmt::format("-{}", k + 1);
    const bool is_named = k < findings.diagram_names.size();
    files.push_back(folder /
                    ((is_named ? findings.diagram_names[k] : findings.name + number) + ".png"));
    write_chart(findings.diagrams[k], ChartOptions{}, files.back());
  }
  write_text(files[1], findings_text(json));
  return files;
}

}  // namespace hackle
