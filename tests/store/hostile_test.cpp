// SPDX-License-Identifier: MIT
// Run files made to do harm: each is refused by an error of its kind, in little time and memory,
// and no message quotes the file.
#include <algorithm>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/stat.h>

#include "base/error.hpp"
#include "base/files.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "store/recording.hpp"
#include "store/run_file.hpp"
#include "support/folder.hpp"
#include "support/scenes.hpp"

namespace hackle::hostile {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* secret = "root:x:0:0:SECRET";
constexpr const char* record = "records/0/00001/";

// Two records of a plate with a disc.
fs::path honest_file(const fs::path& folder) {
  Plate plate = test::bare_plate(30, 20);
  plate.cutouts.push_back({Ellipse{{0.005, 0.005}, {1e-3, 1e-3}, 0.0}, "bore"});
  plate.loads.impactors.push_back({{-4e-3, 0.005}, 2e-3, {80.0, 0.0}, 0.5});
  Simulation simulation(plate, test::numerics(), {1});
  RunFile file(folder / "honest.h5", simulation, {"a.lua", "-- the script"});
  for (int k = 0; k < 2; ++k) {
    file.add(simulation);
    simulation.run(1e-6);
  }
  file.finish();
  return folder / "honest.h5";
}

std::string text_of(hid_t file, const char* name) {
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT), type = H5Dget_type(dataset);
  std::string text(H5Tget_size(type), '\0');
  H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
  H5Tclose(type);
  H5Dclose(dataset);
  return text;
}

// Replaces a dataset by one with this creation list.
void put(hid_t file, const std::string& name, hid_t type, std::vector<hsize_t> shape,
         hid_t plan = H5P_DEFAULT, const void* values = nullptr) {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const hid_t space = shape.empty()
                          ? H5Screate(H5S_SCALAR)
                          : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t made = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, plan, H5P_DEFAULT);
  if (values != nullptr) H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  H5Dclose(made);
  H5Sclose(space);
}

void put_text(hid_t file, const char* name, const std::string& text) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, text.size());
  put(file, name, type, {}, H5P_DEFAULT, text.data());
  H5Tclose(type);
}

void change_inputs(hid_t file, const std::string& from, const std::string& to) {
  std::string text = text_of(file, "inputs");
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  put_text(file, "inputs", text.replace(at, from.size(), to));
}

void put_attribute(hid_t file, const char* name, hid_t type, std::vector<hsize_t> shape) {
  H5Adelete(file, name);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  H5Aclose(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
  H5Sclose(space);
}

void set_number(hid_t file, const char* attribute, long long value) {
  const hid_t found = H5Aopen(file, attribute, H5P_DEFAULT);
  H5Awrite(found, H5T_NATIVE_LLONG, &value);
  H5Aclose(found);
}

// Replaces a dataset by one with its data in other files.
void lead_out(hid_t file, const std::string& name, hid_t type, std::vector<hsize_t> shape,
              hsize_t bytes) {
  const hid_t plan = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(plan, "secret.txt", 0, bytes);
  put(file, name, type, std::move(shape), plan);
  H5Pclose(plan);
}

void lead_out_by_virtue(hid_t file, const std::string& name, hid_t type, hsize_t rows) {
  const hid_t space = H5Screate_simple(1, &rows, nullptr), plan = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_virtual(plan, space, "other.h5", "/secret", space);
  put(file, name, type, {rows}, plan);
  H5Pclose(plan);
  H5Sclose(space);
}

void link_out(hid_t file, const std::string& name, const char* to = "/inputs") {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  H5Lcreate_external("other.h5", to, file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
}

void link_softly(hid_t file, const std::string& name, const char* to) {
  H5Lmove(file, name.c_str(), file, "elsewhere", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft(to, file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
}

// Writes chunks of zeros, a thousand times as large unpacked as packed.
void pack(hid_t file, const std::string& name, hid_t type, std::vector<hsize_t> shape,
          std::vector<hsize_t> piece, int times = 1) {
  const hid_t plan = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(plan, static_cast<int>(piece.size()), piece.data());
  for (int k = 0; k < times; ++k) H5Pset_deflate(plan, 9);
  put(file, name, type, std::move(shape), plan);
  H5Pclose(plan);
}

// Writes a chunk that unpacks to a thousand times its stated size.
void put_bomb(hid_t file, const std::string& name, hsize_t nodes) {
  pack(file, "bomb", H5T_NATIVE_CHAR, {hsize_t{1} << 27U}, {hsize_t{1} << 27U});
  const hid_t source = H5Dopen2(file, "bomb", H5P_DEFAULT);
  const std::vector<char> zeros(std::size_t{1} << 27U);
  H5Dwrite(source, H5T_NATIVE_CHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
  const hsize_t at[2] = {0, 0};
  hsize_t size = 0;
  H5Dget_chunk_storage_size(source, at, &size);
  std::vector<char> packed(size);
  std::uint32_t mask = 0;
  H5Dread_chunk(source, H5P_DEFAULT, at, &mask, packed.data());
  H5Dclose(source);
  H5Ldelete(file, "bomb", H5P_DEFAULT);
  pack(file, name, H5T_NATIVE_FLOAT, {nodes, 3}, {nodes, 3});
  const hid_t target = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  H5Dwrite_chunk(target, H5P_DEFAULT, 0, at, size, packed.data());
  H5Dclose(target);
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

std::string picture(const std::string& columns, const std::string& lengths) {
  return R"({"name": "", "shape": {"kind": "picture", "from_m": [0,0], "to_m": [1,1], "columns": )" +
         columns + R"(, "rows": 4096, "run_lengths": )" + lengths + "}},";
}

const std::string cutouts = "\"cutouts\": [";
constexpr hsize_t nodes = 600;

struct Crafted {
  std::string name;
  std::function<void(hid_t)> by;
  std::string says;  // a part of the refusal
};

std::vector<Crafted> data_elsewhere() {
  std::vector<Crafted> list;
  for (const char* name : {"inputs", "script"})
    list.push_back({std::string("external_") + name,
                    [=](hid_t file) {
                      const hid_t type = H5Tcopy(H5T_C_S1);
                      H5Tset_size(type, 17);
                      lead_out(file, name, type, {}, 17);
                      H5Tclose(type);
                    },
                    "lie in another file"});
  for (const std::string field : {"displacement", "velocity", "broken", "discs"})
    list.push_back({"external_" + field,
                    [=](hid_t file) {
                      lead_out(file, record + field, H5T_NATIVE_FLOAT, {nodes, 3}, nodes * 12);
                    },
                    "lie in another file"});
  for (const std::string name : {"time", "step", "nodes"}) {
    list.push_back({"external_" + name,
                    [=](hid_t file) { lead_out(file, name, H5T_NATIVE_DOUBLE, {2}, 16); },
                    "lie in another file"});
    list.push_back({"virtual_" + name,
                    [=](hid_t file) { lead_out_by_virtue(file, name, H5T_NATIVE_DOUBLE, 2); },
                    "lie in another file"});
  }
  list.push_back({"virtual_displacement",
                  [](hid_t file) {
                    lead_out_by_virtue(file, std::string(record) + "displacement", H5T_NATIVE_FLOAT,
                                       nodes);
                  },
                  "lie in another file"});
  return list;
}

std::vector<Crafted> links() {
  std::vector<Crafted> list;
  for (const std::string name : {"inputs", "script", "time", "step", "nodes", "records",
                                 "records/0", "records/0/00001", "records/0/00001/velocity"}) {
    std::string plain = name;
    std::ranges::replace(plain, '/', '_');
    list.push_back({"external_link_" + plain, [=](hid_t file) { link_out(file, name); },
                    "a link to another file"});
    list.push_back({"soft_link_" + plain,
                    [=](hid_t file) { link_softly(file, name, "/elsewhere"); }, "only a link"});
  }
  list.push_back({"soft_link_in_a_circle",
                  [](hid_t file) { link_softly(file, "inputs", "/inputs"); }, "only a link"});
  list.push_back({"group_in_a_circle",
                  [](hid_t file) {
                    H5Ldelete(file, "records/0/00001", H5P_DEFAULT);
                    H5Lcreate_hard(file, "records", file, "records/0/00001", H5P_DEFAULT,
                                   H5P_DEFAULT);
                  },
                  "is missing or damaged"});
  return list;
}

std::vector<Crafted> packings() {
  const std::string field = std::string(record) + "displacement";
  return {
      {"bomb", [=](hid_t file) { put_bomb(file, field, nodes); }, "is damaged"},
      {"packed_twice",
       [=](hid_t file) {
         pack(file, field, H5T_NATIVE_FLOAT, {nodes, 3}, {nodes, 3}, 2);
       },
       "packed in another way"},
      {"huge_piece",
       [=](hid_t file) {
         pack(file, field, H5T_NATIVE_FLOAT, {nodes, 3}, {nodes, 1U << 28U});
       },
       "missing or damaged"},  // HDF5 does not write it: the dataset is missing
      {"large_piece",
       [=](hid_t file) {
         const hsize_t rows = hsize_t{1} << 28U;
         pack(file, "nodes", H5T_NATIVE_DOUBLE, {rows, 3}, {rows, 1});
       },
       "in pieces of another size"},
      {"many_pieces",
       [=](hid_t file) {
         pack(file, "nodes", H5T_NATIVE_DOUBLE, {1U << 20U, 3}, {1, 1});
       },
       "in pieces of another size"},
      {"other_filter",
       [=](hid_t file) {
         const hid_t plan = H5Pcreate(H5P_DATASET_CREATE);
         const hsize_t piece[2] = {nodes, 1};
         H5Pset_chunk(plan, 2, piece);
         H5Pset_scaleoffset(plan, H5Z_SO_FLOAT_DSCALE, 2);
         put(file, field, H5T_NATIVE_FLOAT, {nodes, 3}, plan);
         H5Pclose(plan);
       },
       "packed in another way"},
      {"text_without_data",
       [](hid_t file) {
         const hid_t type = H5Tcopy(H5T_C_S1);
         H5Tset_size(type, 60'000'000);
         put(file, "inputs", type, {});
         H5Tclose(type);
       },
       "its inputs is missing or damaged"},
      {"text_without_end",
       [](hid_t file) {
         const hid_t type = H5Tcopy(H5T_C_S1);
         H5Tset_size(type, std::size_t{1} << 40U);
         put(file, "script", type, {});
         H5Tclose(type);
       },
       "its script is missing or damaged"},
      {"text_of_any_length",
       [](hid_t file) {
         const hid_t type = H5Tcopy(H5T_C_S1);
         H5Tset_size(type, H5T_VARIABLE);
         put(file, "inputs", type, {}, H5P_DEFAULT, &secret);
         H5Tclose(type);
       },
       "its inputs is missing or damaged"},
      {"texts_for_numbers",
       [=](hid_t file) {
         const hid_t type = H5Tcopy(H5T_C_S1);
         H5Tset_size(type, 8);
         put(file, field, type, {nodes, 3});
         H5Tclose(type);
       },
       "holds no numbers"},
      {"references_for_numbers",
       [=](hid_t file) {
         put(file, field, H5T_STD_REF_OBJ, {nodes, 3});
       },
       "holds no numbers"},
      {"wide_numbers",
       [=](hid_t file) {
         const hid_t type = H5Tcopy(H5T_NATIVE_DOUBLE);
         H5Tset_size(type, 4096);
         put(file, field, type, {nodes, 3});
         H5Tclose(type);
       },
       "holds no numbers"},
      {"many_discs",
       [](hid_t file) {
         put(file, std::string(record) + "discs", H5T_NATIVE_DOUBLE, {900'000, 5});
       },
       "discs is 900000 x 5, expected 1 x 5"},
      {"not_finite",
       [=](hid_t file) {
         const std::vector<double> values(3 * nodes, std::numeric_limits<double>::quiet_NaN());
         put(file, field, H5T_NATIVE_DOUBLE, {nodes, 3}, H5P_DEFAULT, values.data());
       },
       "is not finite"},
      {"no_space",
       [=](hid_t file) {
         put(file, field, H5T_NATIVE_FLOAT, {0, 3});
       },
       "is 0 x 3"},
      {"many_records",
       [](hid_t file) {
         set_number(file, "records_committed", 1'000'000);
         const hsize_t piece = 2048, rows = 1'000'000;
         pack(file, "time", H5T_NATIVE_DOUBLE, {rows}, {piece});
         pack(file, "step", H5T_NATIVE_LLONG, {rows}, {piece});
         const hid_t hash = H5Tcopy(H5T_C_S1);
         H5Tset_size(hash, hash_digits);
         pack(file, "state_hash", hash, {rows}, {piece});
         H5Tclose(hash);
       },
       "is missing or damaged"},
      {"more_records_than_can_be",
       [](hid_t file) { set_number(file, "records_committed", 1LL << 60U); }, "it says that"},
  };
}

std::vector<Crafted> attributes() {
  std::vector<Crafted> list;
  for (const char* name : {"lattice_hash", "script_name", "software"}) {
    list.push_back({std::string("text_of_any_length_") + name,
                    [=](hid_t file) {
                      const hid_t type = H5Tcopy(H5T_C_S1);
                      H5Tset_size(type, H5T_VARIABLE);
                      put_attribute(file, name, type, {1});
                      H5Tclose(type);
                    },
                    "is missing or damaged"});
    list.push_back({std::string("list_") + name,
                    [=](hid_t file) { put_attribute(file, name, H5T_NATIVE_INT, {1000}); },
                    "is missing or damaged"});
  }
  list.push_back(
      {"reference_records_committed",
       [](hid_t file) { put_attribute(file, "records_committed", H5T_STD_REF_OBJ, {1}); },
       "its records_committed is missing or damaged"});
  return list;
}

std::vector<Crafted> inputs() {
  const auto replaced = [](const std::string& from, const std::string& to) {
    return [=](hid_t file) { change_inputs(file, from, to); };
  };
  const auto text = [](const std::string& all) {
    return [=](hid_t file) { put_text(file, "inputs", all); };
  };
  const auto with_cutouts = [&](const std::string& more) {
    return replaced(cutouts, cutouts + more);
  };
  const std::string all_dark = "[0, 16777216]", all_dark_text = "\"0 16777216\"";
  return {
      {"password_file", text(repeated(std::string(secret) + "\n", 40)), "no JSON at byte"},
      {"deep_lists", text(std::string(40'000'000, '[')), "it goes too deep"},
      {"deep_objects", text(repeated("{\"a\":", 4'000'000)), "it goes too deep"},
      {"many_values", text("[" + repeated("0,", 30'000'000) + "0]"), "holds more than"},
      {"broken_utf8", text("{\"plate\": \"\xff\xfe\xc0\x80\"}"), "no JSON at byte"},
      {"huge_number", replaced("\"width_m\": ", "\"width_m\": 1e999, \"x\": "), "cannot be read"},
      {"three_thousand_pictures", with_cutouts(repeated(picture("4096", all_dark), 3000)),
       "its pictures are too many"},
      {"three_thousand_texts", with_cutouts(repeated(picture("4096", all_dark_text), 3000)),
       "its pictures are too many"},
      {"picture_too_large", with_cutouts(picture("2000000000", all_dark)), "too large"},
      {"picture_of_less_than_nothing", with_cutouts(picture("-4096", "[0, -16777216]")),
       "no cells"},
      {"runs_too_long", with_cutouts(picture("4096", "[9000000000000000000, 9000000000000000000]")),
       "too many cells"},
      {"runs_of_text", with_cutouts(picture("4096", "\"1 2 SECRET\"")), "no picture"},
      {"runs_too_short", with_cutouts(picture("4096", "[]")), "too few cells"},
      {"wide_plate", replaced("\"width_m\": ", "\"width_m\": 1000.0, \"x\": "), "cannot read"},
      {"fine_lattice", replaced("\"spacing_m\": 0.0005", "\"spacing_m\": 5e-6"), "cannot read"},
      {"other_lattice", replaced("\"spacing_m\": 0.0005", "\"spacing_m\": 0.0004"),
       "its nodes is 600 x 3, expected"},
      {"many_inclusions",
       [=](hid_t file) {
         const std::string all = text_of(file, "inputs");
         const std::size_t begin = all.find("\"material\": ") + 12;
         const std::string material = all.substr(begin, all.find('}') + 1 - begin);
         change_inputs(
             file, "\"inclusions\": [",
             "\"inclusions\": [" +
                 repeated(R"({"shape": {"kind": "polygon", "points_m": []}, "material": )" +
                              material + "},",
                          300) +
                 R"({"shape": {"kind": "polygon", "points_m": []}, "material": )" + material + "}");
       },
       "cannot read"},
      {"name_of_a_material",
       [](hid_t file) {
         change_inputs(file, "\"name\": \"Duran", "\"name\": \"SECRET");
         change_inputs(file, "\"E_Pa\": ", "\"E_Pa\": -");
       },
       "E is -"},
      {"name_of_a_hole", replaced("\"name\": \"bore\"", "\"name\": 5"), "another type"},
      {"name_of_a_shape", replaced("\"kind\": \"ellipse\"", "\"kind\": \"SECRET\""),
       "a shape is none of"},
      {"nothing", text(" "), "no JSON"},
      {"a_list", text("[]"), "another type"},
      {"an_empty_object", text("{}"), "missing"},
  };
}

std::vector<Crafted> all_crafted() {
  std::vector<Crafted> all;
  for (const auto& part : {data_elsewhere(), links(), packings(), attributes(), inputs()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

// Returns the error of showing every record, "" if there is none.
std::string complaint(const fs::path& path) {
  try {
    Recording recording(path);
    for (std::size_t k = 0; k < recording.times().size(); ++k) recording.go_to(k);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::files) << error.what();
    return error.what();
  }
}

class Hostile : public testing::Test {
 protected:
  Hostile() {
    write_text(folder.path / "secret.txt", repeated(secret, 2000));
    const hid_t other =
        H5Fcreate((folder.path / "other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    put_text(other, "inputs", secret);
    put_text(other, "secret", secret);
    H5Fclose(other);
  }

  fs::path crafted(const std::function<void(hid_t)>& by) const {
    const fs::path path = folder.path / "crafted.h5";
    fs::copy_file(honest, path, fs::copy_options::overwrite_existing);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    by(file);
    H5Fclose(file);
    return path;
  }

  const test::Folder folder;
  const fs::path honest = honest_file(folder.path);
};

TEST_F(Hostile, FilesAreRefusedByKindSoonInLittleMemoryAndUnquoted) {
  ASSERT_EQ(complaint(honest), "");
  const std::vector<Crafted> all = all_crafted();
  constexpr double max_seconds = 20.0;  // of a processor; each case takes less than one
  constexpr std::uint64_t max_memory = 1'500'000'000;  // 128 MB belong to this test itself
  for (const Crafted& one : all) {
    SCOPED_TRACE(one.name);
    const fs::path path = crafted(one.by);
    const std::clock_t begin = std::clock();
    const std::string told = complaint(path);
    const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_THAT(told, HasSubstr(one.says));
    EXPECT_THAT(told, testing::Not(HasSubstr("SECRET")));
    EXPECT_THAT(told, testing::Not(HasSubstr("root:")));
    EXPECT_LT(taken, max_seconds);
    EXPECT_LT(peak_resident_memory(), max_memory);
  }
  RecordProperty("crafted_files", static_cast<int>(all.size()));
  std::printf("%zu crafted files\n", all.size());
  EXPECT_GE(all.size(), 60U);
}

TEST_F(Hostile, WhatIsNoPlainFileIsNotOpened) {
  const fs::path pipe = folder.path / "pipe.h5";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(complaint(pipe), HasSubstr("it is no plain file"));
  EXPECT_THAT(complaint("/dev/zero"), HasSubstr("it is no plain file"));
  EXPECT_THAT(complaint("/etc/passwd"), HasSubstr("it is no HDF5 file"));
}

// Every byte of the beginning, where the structures of the file lie, is flipped.
TEST_F(Hostile, TurnedBytesDoNoHarm) {
  const std::string whole = read_text(honest);
  const fs::path path = folder.path / "turned.h5";
  for (std::size_t at = 0; at < whole.size(); at += at < 4096 ? 37 : 997) {
    std::string turned = whole;
    turned[at] = static_cast<char>(~turned[at]);
    write_text(path, turned);
    complaint(path);  // any error or none, but of the right kind
  }
}

TEST_F(Hostile, ReadingEndsOnCtrlC) {
  request_interrupt();
  try {
    const Recording recording(honest);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
  clear_interrupt();
}

}  // namespace
}  // namespace hackle::hostile
