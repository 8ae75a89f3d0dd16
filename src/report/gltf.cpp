// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/gltf.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "report/drawing.h"

// A GLB file is a header, a chunk of JSON and a chunk of bytes, each padded to four bytes; the
// bytes are little-endian, each array a view of its own. Colours of vertices are linear.

namespace seam::report {
namespace {

using Json = nlohmann::ordered_json;

// glTF's names for numbers, kinds of buffers and of primitives.
constexpr int unsigned_short = 5123, unsigned_int = 5125, float_32 = 5126;
constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int points_mode = 0, lines_mode = 1, triangles_mode = 4;

template <class Unsigned>
void append(std::string& bytes, Unsigned number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    bytes += static_cast<char>((number >> (8 * i)) & 0xFF);
}

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

class Model {
 public:
  explicit Model(const FigureRun& figure) : figure_(figure) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "seamproof"}};
    json_["extras"] = {{"title", figure.title}, {"description", description(figure)}};
  }

  std::string written() {
    if (!figure_.triangles.empty()) facets();
    for (const auto kind : {FigureRun::Line::Kind::seam, FigureRun::Line::Kind::edge,
                            FigureRun::Line::Kind::net, FigureRun::Line::Kind::curvature,
                            FigureRun::Line::Kind::curve, FigureRun::Line::Kind::contour})
      lines(kind);
    if (!figure_.marks.empty()) marks();

    Json scene;
    scene["name"] = figure_.title;
    if (!primitives_.empty()) {
      json_["meshes"] = {{{"name", figure_.title}, {"primitives", primitives_}}};
      // A quarter turn about x: z of the figure is y of the model.
      const double half = std::sqrt(0.5);
      json_["nodes"] = {{{"mesh", 0}, {"rotation", {-half, 0, 0, half}}}};
      scene["nodes"] = {0};
      json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    }
    json_["scenes"] = Json::array({scene});
    json_["scene"] = 0;
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');

    std::string result = "glTF";
    const bool binary = !bytes_.empty();
    append<std::uint32_t>(result, 2);
    append<std::uint32_t>(result, static_cast<std::uint32_t>(20 + text.size() +
                                                             (binary ? 8 + bytes_.size() : 0)));
    append<std::uint32_t>(result, static_cast<std::uint32_t>(text.size()));
    result += "JSON" + text;
    if (!binary) return result;
    append<std::uint32_t>(result, static_cast<std::uint32_t>(bytes_.size()));
    return result + std::string("BIN\0", 4) + bytes_;
  }

 private:
  // The bytes added since the last view as an array of so many elements.
  int accessor(std::size_t count, int component, const char* type, int target) {
    const std::size_t begin = view_end_;
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", begin},
                                    {"byteLength", bytes_.size() - begin},
                                    {"target", target}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", component},
                                  {"count", count},
                                  {"type", type}});
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    view_end_ = bytes_.size();
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int vectors(const std::vector<FigureRun::Point>& all, bool bounds) {
    std::array<float, 3> low{}, high{};
    for (const auto& vector : all)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto x = static_cast<float>(vector[i]);
        append(bytes_, std::bit_cast<std::uint32_t>(x));
        low[i] = &vector == all.data() ? x : std::min(low[i], x);
        high[i] = &vector == all.data() ? x : std::max(high[i], x);
      }
    const int result = accessor(all.size(), float_32, "VEC3", array_buffer);
    if (!bounds) return result;
    json_["accessors"].back()["min"] = low;
    json_["accessors"].back()["max"] = high;
    return result;
  }

  int indices(const std::vector<std::uint32_t>& all) {
    for (const std::uint32_t i : all) append(bytes_, i);
    return accessor(all.size(), unsigned_int, "SCALAR", element_array_buffer);
  }

  int colours() {
    const Scale scale = scale_of(figure_.values);
    for (const double value : figure_.values) {
      const Colour shown = colour(scale, value);
      for (const double channel : {linear(shown[0]), linear(shown[1]), linear(shown[2]), 1.0})
        append(bytes_, static_cast<std::uint16_t>(std::lround(65535 * channel)));
    }
    const int result = accessor(figure_.values.size(), unsigned_short, "VEC4", array_buffer);
    json_["accessors"].back()["normalized"] = true;
    return result;
  }

  void add(int mode, Json attributes, int at, const Json& material) {
    json_["materials"].push_back(material);
    primitives_.push_back({{"attributes", std::move(attributes)},
                           {"indices", at},
                           {"material", json_["materials"].size() - 1},
                           {"mode", mode}});
  }

  static Json paint(const std::string& name, const Colour& c) {
    return {{"name", name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {linear(c[0]), linear(c[1]), linear(c[2]), 1}},
              {"metallicFactor", 0},
              {"roughnessFactor", 0.7}}}};
  }

  void facets() {
    Json attributes = {{"POSITION", vectors(figure_.points, true)}};
    if (!figure_.normals.empty()) attributes["NORMAL"] = vectors(figure_.normals, false);
    if (!figure_.values.empty()) attributes["COLOR_0"] = colours();
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : figure_.triangles)
      for (const int i : triangle) corners.push_back(static_cast<std::uint32_t>(i));
    Json material =
        paint("facets", figure_.values.empty() ? Colour{0.74, 0.79, 0.84} : Colour{1, 1, 1});
    if (!figure_.closed) material["doubleSided"] = true;
    add(triangles_mode, std::move(attributes), indices(corners), material);
  }

  // Not lit.
  void flat(int mode, const std::vector<FigureRun::Point>& points,
            const std::vector<std::uint32_t>& at, const std::string& name, const Colour& c) {
    Json material = paint(name, c);
    material["extensions"]["KHR_materials_unlit"] = Json::object();
    json_["extensionsUsed"] = {"KHR_materials_unlit"};
    Json attributes = {{"POSITION", vectors(points, true)}};
    add(mode, std::move(attributes), indices(at), material);
  }

  void lines(FigureRun::Line::Kind kind) {
    std::vector<FigureRun::Point> points;
    std::vector<std::uint32_t> at;
    for (const FigureRun::Line& line : figure_.lines) {
      if (line.kind != kind) continue;
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        const auto next = static_cast<std::uint32_t>(points.size());
        if (i > 0) at.insert(at.end(), {next - 1, next});
        points.push_back(line.points[i]);
      }
    }
    if (!at.empty())
      flat(lines_mode, points, at, word(kind), style_of(stroke_kind(kind)).colour);
  }

  void marks() {
    std::vector<FigureRun::Point> points;
    std::vector<std::uint32_t> at;
    for (const FigureRun::Mark& mark : figure_.marks) {
      at.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(mark.at);
    }
    flat(points_mode, points, at, "refuted", {0.75, 0.1, 0.05});
  }

  const FigureRun& figure_;
  Json json_;
  Json primitives_ = Json::array();
  std::string bytes_;
  std::size_t view_end_ = 0;
};

}  // namespace

std::string glb(const FigureRun& figure) {
  return Model(figure).written();
}

}  // namespace seam::report
