// SPDX-License-Identifier: MIT
#include "output/files/graph_file.hpp"

#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/files.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json place_of(const Vec2& place) {
  return {place.x(), place.y()};
}

void set_if(Json& json, const char* key, const std::optional<double>& value) {
  if (value) json[key] = *value;
}

std::optional<double> known(double time) {
  return std::isfinite(time) ? std::optional(time) : std::nullopt;
}

Json to_json(const CrackPiece& piece) {
  Json json{{"parent", piece.parent}, {"initial", piece.initial}, {"length_m", piece.length}};
  set_if(json, "born_s", known(piece.times.front()));
  set_if(json, "max_speed_m_per_s", piece.max_speed);
  Json& points = json["points_m"] = Json::array();
  for (const Vec2& point : piece.points) points.push_back(place_of(point));
  Json& times = json["times_s"] = Json::array();
  if (!piece.initial)
    for (const double time : piece.times) times.push_back(known(time) ? Json(time) : Json());
  return json;
}

Json to_json(const CrackTip& tip, double rayleigh) {
  return {{"crack", tip.crack},
          {"place_m", place_of(tip.place)},
          {"direction", place_of(tip.direction)},
          {"state", name_of(tip.state)},
          {"speed_m_per_s", tip.speed},
          {"share_of_c_R", rayleigh > 0.0 ? tip.speed / rayleigh : 0.0}};
}

Json to_json(const CrackEvent& event, double rayleigh) {
  Json json{{"kind", name_of(event.kind)}};
  set_if(json, "time_s", event.time);
  json["place_m"] = place_of(event.place);
  json["crack"] = event.crack;
  if (event.other >= 0) json["other"] = event.other;
  set_if(json, "angle_rad", event.angle);
  set_if(json, "speed_m_per_s", event.speed);
  if (event.speed && rayleigh > 0.0) json["share_of_c_R"] = *event.speed / rayleigh;
  const bool has_site =
      event.kind == CrackEventKind::arrival || event.kind == CrackEventKind::nucleation;
  if (has_site) json["site"] = name_of(event.site);
  return json;
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string paths_csv(const CrackGraph& graph) {
  std::string text = "crack,parent,initial,x_m,y_m,way_m,time_s\n";
  for (std::size_t number = 0; number < graph.cracks.size(); ++number) {
    const CrackPiece& piece = graph.cracks[number];
    double way = 0.0;
    for (std::size_t k = 0; k < piece.points.size(); ++k) {
      if (k > 0) way += (piece.points[k] - piece.points[k - 1]).norm();
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", number, piece.parent,
                     piece.initial ? 1 : 0, piece.points[k].x(), piece.points[k].y(), way,
                     cell(known(piece.times[k])));
    }
  }
  return text;
}

std::string tips_csv(const CrackGraph& graph) {
  std::string text = "crack,state,x_m,y_m,direction_x,direction_y,speed_m_per_s\n";
  for (const CrackTip& tip : graph.tips)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", tip.crack,
                   name_of(tip.state), tip.place.x(), tip.place.y(), tip.direction.x(),
                   tip.direction.y(), tip.speed);
  return text;
}

std::string events_csv(const CrackGraph& graph) {
  std::string text = "kind,time_s,x_m,y_m,crack,other,angle_rad,speed_m_per_s,site\n";
  for (const CrackEvent& event : graph.events)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", name_of(event.kind),
                   cell(event.time), event.place.x(), event.place.y(), event.crack,
                   event.other >= 0 ? fmt::format("{}", event.other) : "", cell(event.angle),
                   cell(event.speed), name_of(event.site));
  return text;
}

}  // namespace

Json to_json(const std::vector<CrackEvent>& events, double rayleigh) {
  Json json = Json::array();
  for (const CrackEvent& event : events) json.push_back(to_json(event, rayleigh));
  return json;
}

Json to_json(const CrackGraph& graph) {
  Json json{{"time_s", graph.time}, {"c_R_m_per_s", graph.rayleigh}};
  Json& cracks = json["cracks"] = Json::array();
  for (const CrackPiece& piece : graph.cracks) cracks.push_back(to_json(piece));
  Json& tips = json["tips"] = Json::array();
  for (const CrackTip& tip : graph.tips) tips.push_back(to_json(tip, graph.rayleigh));
  json["events"] = to_json(graph.events, graph.rayleigh);
  return json;
}

std::string to_csv(const CrackGraph& graph, GraphTable table) {
  if (table == GraphTable::tips) return tips_csv(graph);
  return table == GraphTable::events ? events_csv(graph) : paths_csv(graph);
}

void check_graph_ending(const std::string& who, const std::filesystem::path& path) {
  if (path.extension() == ".json" || path.extension() == ".csv") return;
  throw Error(ErrorKind::refused, fmt::format("{}: '{}' is no name of a graph", who, path.string()),
              "it ends in .json, or in .csv for one of its tables");
}

void write_graph(const CrackGraph& graph, GraphTable table, const std::filesystem::path& path) {
  make_folder_of(path);
  write_text(path,
             path.extension() == ".json" ? to_json(graph).dump(1) + "\n" : to_csv(graph, table));
}

}  // namespace hackle
