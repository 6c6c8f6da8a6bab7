// SPDX-License-Identifier: MIT
#include "store/run_facts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "store/hdf5_reader.hpp"
#include "store/xdmf.hpp"

namespace hackle {
namespace {

void add_bytes(std::vector<StoredField>& fields, const std::string& name, std::uint64_t bytes) {
  const auto known = std::ranges::find(fields, name, &StoredField::name);
  if (known == fields.end())
    fields.push_back({name, bytes});
  else
    known->bytes += bytes;
}

std::string attribute_or_none(const Hdf5Reader& file, const std::string& name) {
  return file.has_attribute(name) ? file.attribute(name) : "";
}

std::vector<StoredField> fields_of(const Hdf5Reader& file, std::int64_t records) {
  std::vector<StoredField> fields;
  for (std::int64_t k = 0; k < records; ++k) {
    const std::string group = record_group(static_cast<std::size_t>(k));
    for (const std::string& name : file.names(group))
      add_bytes(fields, name, file.stored_bytes(fmt::format("{}/{}", group, name)));
  }
  for (const std::string& name : file.names("/"))
    if (name != "records") add_bytes(fields, name, file.stored_bytes(name));
  return fields;
}

void read_records(const Hdf5Reader& file, RunFacts& facts) {
  facts.records = file.integer("records_committed");
  if (facts.records < 0 || facts.records > max_records)
    file.refuse(fmt::format("it says that it holds {} records", facts.records));
  if (facts.records == 0) return;
  const auto count = static_cast<hsize_t>(facts.records);
  facts.times = file.first_doubles("time", count);
  facts.last_step = file.first_integers("step", count).back();
}

}  // namespace

RunFacts facts_of_run(const std::filesystem::path& path) {
  RunFacts facts;
  const Hdf5Reader file(path);
  if (attribute_or_none(file, "software") != "Hackle" || !file.has_attribute("format_version"))
    file.refuse("it is no run file of Hackle", "s:record{} writes run files");
  facts.format = file.integer("format_version");
  facts.version = attribute_or_none(file, "version");
  facts.git_hash = attribute_or_none(file, "git_hash");
  facts.compiler = attribute_or_none(file, "compiler");
  facts.created = attribute_or_none(file, "created");
  facts.origin = {attribute_or_none(file, "script_name"), file.text("script")};
  facts.inputs = file.text("inputs");
  facts.is_complete = file.integer("complete") != 0;
  read_records(file, facts);
  facts.fields = fields_of(file, facts.records);
  return facts;
}

}  // namespace hackle
