#include <algorithm>
#include <cmath>

#include "runner/queries/queries.hpp"
#include "runner/queries/typed_value.hpp"
#include "runner/render/shape_files.hpp"
#include "runner/render/shape_tensors.hpp"
#include "runner/web/handlers.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMaxBytes = 4 << 20;  // of the numbers in one answer

/// The shape that was recorded nearest to a time. \param shapes  not empty
std::size_t nearest(const std::vector<RecordedShape>& shapes, double kt) {
  const auto distance = [kt](const RecordedShape& shape) { return std::abs(shape.kt - kt); };
  return static_cast<std::size_t>(std::ranges::min_element(shapes, {}, distance) - shapes.begin());
}

ordered_json list_of(const std::vector<RecordedShape>& shapes) {
  ordered_json times = ordered_json::array();
  for (const RecordedShape& shape : shapes) times.push_back(shape.kt);
  return {{"kt", times}};
}

Response file_response(const std::string& type, std::string body) { return {200, type, std::move(body), {}}; }

/// The shapes from `first` on that fit in one answer, at least one, at most `count`.
Response tensors_response(const RunDirectory& run, const std::vector<RecordedShape>& shapes,
                          std::size_t first, std::size_t count) {
  ShapeRange range{first, shapes.size(), {}};
  std::vector<ShapeArrays> arrays;
  std::size_t bytes = 0, bytes_of_one = 0;
  for (std::size_t i = first; i < shapes.size() && arrays.size() < count; ++i) {
    if (!arrays.empty() && bytes + bytes_of_one > kMaxBytes) break;
    arrays.push_back(read_shape(run, shapes[i]));
    range.times.push_back(shapes[i].kt);
    bytes_of_one = 10 * sizeof(float) * arrays.back().positions.size() / 3;
    bytes += bytes_of_one;
  }
  return file_response("application/octet-stream", as_tensors(range, arrays, read_triangles(run)));
}

Response shape_response(const RunDirectory& run, const std::vector<RecordedShape>& shapes,
                        const std::string& format, double kt) {
  const std::size_t index = nearest(shapes, kt);
  if (format == "binary") return tensors_response(run, shapes, index, 1);
  const TriangulatedShape shape{shapes[index].kt, read_shape(run, shapes[index]), read_triangles(run)};
  if (format == "vtp") return file_response("application/xml", as_vtp(shape));
  if (format == "stl") return file_response("model/stl", as_stl(shape));
  return file_response("model/obj", as_obj(shape));
}

}  // namespace

/// Without a format, the list of the times. Else one shape, the nearest to `kt`, or in the format `binary`
/// the shapes from the index `first` on.
Response get_case_shapes(Service& service, const httplib::Request& request, const std::string& id) {
  if (!find_case(*service.reader(), id)) return problem(404, "Not found", "there is no case \"" + id + "\"");
  const RunDirectory run = service.data().run(id);
  const std::vector<RecordedShape> shapes = recorded_shapes(run);
  const std::string format = request.get_param_value("format");
  if (format.empty() || format == "json") return json_response(200, list_of(shapes));
  if (shapes.empty())
    return problem(404, "Not found",
                   "the case has recorded no shapes; \"outputs\": {\"shapes_every\": 0.5} in a case or a "
                   "study records one each kt = 0.5");
  const auto kt = number_in<double>(request.get_param_value("kt"));
  if (kt) return shape_response(run, shapes, format, *kt);
  if (format != "binary")
    return problem(400, "Invalid query", "the query makes no sense here",
                   {{"kt", "is needed: a file of this format holds the shape at one time"}});
  const auto first = number_in<std::size_t>(request.get_param_value("first")).value_or(0);
  if (first >= shapes.size())
    return problem(404, "Not found", "the case has " + std::to_string(shapes.size()) + " shapes");
  return tensors_response(run, shapes, first, shapes.size());
}

}  // namespace capstan
