// SPDX-License-Identifier: MIT
#include "console/reference/vocabulary.hpp"

#include <algorithm>

#include "console/language/background_binding.hpp"
#include "console/language/chart_binding.hpp"
#include "console/language/checkpoint_binding.hpp"
#include "console/language/contact_sheet_binding.hpp"
#include "console/language/expect_binding.hpp"
#include "console/language/gauge_binding.hpp"
#include "console/language/help_binding.hpp"
#include "console/language/load_binding.hpp"
#include "console/language/material_binding.hpp"
#include "console/language/options_binding.hpp"
#include "console/language/plate_binding.hpp"
#include "console/language/recording_binding.hpp"
#include "console/language/show_binding.hpp"
#include "console/language/simulation_binding.hpp"
#include "console/language/study_binding.hpp"
#include "console/language/values_binding.hpp"

namespace hackle {

std::vector<const TypeDoc*> all_types() {
  return {&material_type(),  &plate_type(), &simulation_type(),
          &recording_type(), &gauge_type(), &values_type()};
}

std::vector<Function> all_functions() {
  std::vector<Function> list;
  for (const auto functions :
       {material_functions(), plate_functions(), amplitude_functions(), simulation_functions(),
        background_functions(), show_functions(), checkpoint_functions(), recording_functions(),
        contact_sheet_functions(), chart_functions(), gauge_functions(), expect_functions(),
        options_functions(), study_functions(), help_functions()})
    list.insert(list.end(), functions.begin(), functions.end());
  return list;
}

std::vector<const FunctionDoc*> all_docs() {
  std::vector<const FunctionDoc*> docs;
  for (const Function& function : all_functions()) docs.push_back(function.doc);
  for (const TypeDoc* type : all_types())
    for (const Function& method : type->methods) docs.push_back(method.doc);
  return docs;
}

const TypeDoc* find_type(std::string_view name) {
  for (const TypeDoc* type : all_types())
    if (type->name == name) return type;
  return nullptr;
}

}  // namespace hackle
