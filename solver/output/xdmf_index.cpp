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

/// \param shape  "642 3"   \param where  FILE:/ARRAY
std::string data_item(const std::string& shape, Number number, const std::string& where) {
  const std::string type = number == Number::integer
                               ? attribute("NumberType", "Int") + attribute("Precision", "4")
                               : attribute("NumberType", "Float") + attribute("Precision", "8");
  return element("DataItem", attribute("Dimensions", shape) + type + attribute("Format", "HDF"), where);
}

/// \param type  "Vector" or "Scalar"
std::string vertex_field(const std::string& name, const std::string& type, const std::string& data) {
  return element("Attribute",
                 attribute("Name", name) + attribute("AttributeType", type) + attribute("Center", "Node"),
                 data);
}

std::string topology(const XdmfMesh& mesh) {
  return element(
      "Topology",
      attribute("TopologyType", "Triangle") + attribute("NumberOfElements", std::to_string(mesh.face_count)),
      data_item(std::to_string(mesh.face_count) + " 3", Number::integer, mesh.file + ":/faces"));
}

std::string frame_grid(const XdmfMesh& mesh, const XdmfFrame& frame) {
  const std::string vertices = std::to_string(mesh.vertex_count);
  const auto vectors = [&](const std::string& array) {
    return data_item(vertices + " 3", Number::real, frame.file + ":/" + array);
  };
  const std::string stretches = data_item(vertices, Number::real, frame.file + ":/stretches");
  return element("Grid", attribute("Name", "membrane") + attribute("GridType", "Uniform"),
                 element("Time", attribute("Value", shown(frame.kt)), "") + topology(mesh) +
                     element("Geometry", attribute("GeometryType", "XYZ"), vectors("positions")) +
                     vertex_field("velocity", "Vector", vectors("velocities")) +
                     vertex_field("force", "Vector", vectors("forces")) +
                     vertex_field("stretch", "Scalar", stretches));
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
