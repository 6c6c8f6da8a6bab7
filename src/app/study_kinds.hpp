// SPDX-License-Identifier: MIT
// The kinds of hackle study, each described and carried out in a file of its own.
#pragma once

#include "app/study_words.hpp"

namespace hackle {

// Adds hackle study with its kinds. The action of the one that is called is set.
void describe_study(CLI::App& app, StudyAction& action);

// Throws Error (usage), with the nearest name, if the words after `hackle study` name no kind.
void check_study_kind(const CLI::App& app, const std::vector<std::string>& words);

void describe_study_ensemble(CLI::App& study, StudyAction& action);
void describe_study_envelope(CLI::App& study, StudyAction& action);
void describe_study_features(CLI::App& study, StudyAction& action);
void describe_study_trade(CLI::App& study, StudyAction& action);
void describe_study_convergence(CLI::App& study, StudyAction& action);
void describe_study_sweep(CLI::App& study, StudyAction& action);
void describe_study_fit(CLI::App& study, StudyAction& action);

}  // namespace hackle
