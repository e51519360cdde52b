#include "solver/output/xdmf_index.hpp"

#include <array>
#include <charconv>

namespace capstan {
namespace {

/// The shortest decimal form that reads back to the same double.
std::string shown(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

std::string attribute(const std::string& name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

std::string element(const std::string& name, const std::string& attributes, const std::string& content) {
  return std::string("<") + name + attributes + ">" + content + "</" + name + ">\n";
}

enum class Number { integer, real };

/// An array of `rows` x 3 numbers; `where` is FILE:/ARRAY.
std::string data_item(long rows, Number number, const std::string& where) {
  const std::string type = number == Number::integer
                               ? attribute("NumberType", "Int") + attribute("Precision", "4")
                               : attribute("NumberType", "Float") + attribute("Precision", "8");
  return element("DataItem",
                 attribute("Dimensions", std::to_string(rows) + " 3") + type + attribute("Format", "HDF"),
                 where);
}

std::string vertex_field(const std::string& name, const std::string& data) {
  return element("Attribute",
                 attribute("Name", name) + attribute("AttributeType", "Vector") + attribute("Center", "Node"),
                 data);
}

std::string topology(const XdmfMesh& mesh) {
  return element(
      "Topology",
      attribute("TopologyType", "Triangle") + attribute("NumberOfElements", std::to_string(mesh.face_count)),
      data_item(mesh.face_count, Number::integer, mesh.file + ":/faces"));
}

std::string frame_grid(const XdmfMesh& mesh, const XdmfFrame& frame) {
  const auto per_vertex = [&](const std::string& array) {
    return data_item(mesh.vertex_count, Number::real, frame.file + ":/" + array);
  };
  return element("Grid", attribute("Name", "membrane") + attribute("GridType", "Uniform"),
                 element("Time", attribute("Value", shown(frame.kt)), "") + topology(mesh) +
                     element("Geometry", attribute("GeometryType", "XYZ"), per_vertex("positions")) +
                     vertex_field("velocity", per_vertex("velocities")) +
                     vertex_field("force", per_vertex("forces")));
}

}  // namespace

std::string xdmf_index(const XdmfMesh& mesh, const std::vector<XdmfFrame>& frames) {
  std::string grids;
  for (const XdmfFrame& frame : frames) grids += frame_grid(mesh, frame);
  const std::string collection =
      element("Grid", attribute("GridType", "Collection") + attribute("CollectionType", "Temporal"), grids);
  return std::string("<?xml version=\"1.0\"?>\n") +
         element("Xdmf", attribute("Version", "2.0"), element("Domain", "", collection));
}

}  // namespace capstan
