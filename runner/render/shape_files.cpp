#include "runner/render/shape_files.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace capstan {
namespace {

/// The shortest decimal form that reads back to the same number.
template <class Number>
std::string shown(Number number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

template <class Number>
std::string in_lines_of_three(std::span<const Number> numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += shown(numbers[i]) + ((i + 1) % 3 == 0 || i + 1 == numbers.size() ? "\n" : " ");
  return text;
}

/// \param attributes  of the array beside its type
template <class Number>
std::string data_array(const std::string& type, const std::string& attributes,
                       const std::vector<Number>& numbers) {
  return "<DataArray type=\"" + type + "\" " + attributes + " format=\"ascii\">\n" +
         in_lines_of_three<Number>(numbers) + "</DataArray>\n";
}

std::string vector_array(const std::string& name, const std::vector<double>& numbers) {
  return data_array("Float64", "Name=\"" + name + "\" NumberOfComponents=\"3\"", numbers);
}

/// 3, 6, 9 ..: where the vertices of each triangle end.
std::vector<int> ends_of_triangles(std::size_t count) {
  std::vector<int> ends(count);
  for (std::size_t i = 0; i < count; ++i) ends[i] = static_cast<int>(3 * (i + 1));
  return ends;
}

using Vector = std::array<float, 3>;

Vector position_of(const TriangulatedShape& shape, int vertex) {
  const double* const at = shape.arrays.positions.data() + 3 * static_cast<std::size_t>(vertex);
  return {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
}

/// The outward normal of length 1; 0 for a triangle without area.
Vector normal_of(const Vector& a, const Vector& b, const Vector& c) {
  const Vector u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return length > 0 ? Vector{n[0] / length, n[1] / length, n[2] / length} : Vector{0, 0, 0};
}

/// Appends the bytes as they are in memory: little-endian on the processors that Capstan runs on.
template <class Value>
void append_bytes(std::string& text, const Value& value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The text of an attribute in XML.
std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text)
    all += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return all;
}

}  // namespace

std::string as_vtp(const TriangulatedShape& shape) {
  const ShapeArrays& arrays = shape.arrays;
  const std::size_t triangles = shape.triangles.size() / 3;
  std::string fields = vector_array("velocity", arrays.velocities) + vector_array("force", arrays.forces);
  if (!arrays.stretches.empty()) fields += data_array("Float64", "Name=\"stretch\"", arrays.stretches);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<PolyData>\n<FieldData>\n" +
         data_array("Float64", "Name=\"TimeValue\" NumberOfTuples=\"1\"", std::vector<double>{shape.kt}) +
         "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(arrays.positions.size() / 3) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(triangles) + "\">\n<PointData>\n" + fields + "</PointData>\n<Points>\n" +
         vector_array("Points", arrays.positions) + "</Points>\n<Polys>\n" +
         data_array("Int32", "Name=\"connectivity\"", shape.triangles) +
         data_array("Int32", "Name=\"offsets\"", ends_of_triangles(triangles)) +
         "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string as_stl(const TriangulatedShape& shape) {
  constexpr std::size_t kHeader = 80;
  std::string bytes = "capsule at kt = " + shown(shape.kt);
  bytes.resize(kHeader);
  append_bytes(bytes, static_cast<std::uint32_t>(shape.triangles.size() / 3));
  for (std::size_t i = 0; i + 2 < shape.triangles.size(); i += 3) {
    const Vector a = position_of(shape, shape.triangles[i]), b = position_of(shape, shape.triangles[i + 1]),
                 c = position_of(shape, shape.triangles[i + 2]);
    for (const Vector& vector : {normal_of(a, b, c), a, b, c}) append_bytes(bytes, vector);
    append_bytes(bytes, std::uint16_t(0));
  }
  return bytes;
}

std::string as_obj(const TriangulatedShape& shape) {
  std::string text = "# capsule at kt = " + shown(shape.kt) + "\n";
  const std::vector<double>& x = shape.arrays.positions;
  for (std::size_t i = 0; i + 2 < x.size(); i += 3)
    text += "v " + shown(x[i]) + " " + shown(x[i + 1]) + " " + shown(x[i + 2]) + "\n";
  const std::vector<int>& t = shape.triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3)  // OBJ counts vertices from 1
    text += "f " + shown(t[i] + 1) + " " + shown(t[i + 1] + 1) + " " + shown(t[i + 2] + 1) + "\n";
  return text;
}

std::string as_pvd(const std::vector<TimeAndFile>& files) {
  std::string entries;
  for (const auto& [kt, file] : files)
    entries += "<DataSet timestep=\"" + shown(kt) + "\" file=\"" + escaped(file) + "\"/>\n";
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n"
         "<Collection>\n" +
         entries + "</Collection>\n</VTKFile>\n";
}

}  // namespace capstan
