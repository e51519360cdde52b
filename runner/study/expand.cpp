#include "runner/study/expand.hpp"

namespace capstan {

AxisIndices axis_indices(const std::vector<Axis>& axes, std::size_t point) {
  AxisIndices indices(axes.size());
  for (std::size_t axis = axes.size(); axis-- > 0;) {
    const auto size = static_cast<std::size_t>(axes[axis].size());
    indices[axis] = point % size;
    point /= size;
  }
  return indices;
}

double product_size(const std::vector<Axis>& axes) {
  double size = 1;
  for (const Axis& axis : axes) size *= axis.size();
  return size;
}

std::string study_pointer(const std::string& case_pointer, const std::vector<Axis>& axes,
                          const AxisIndices& indices) {
  const std::string parameter = first_token(case_pointer);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    if (axes[axis].parameter() == parameter)
      return axes[axis].pointer(indices[axis], case_pointer.substr(1 + parameter.size()));
  return "/base" + case_pointer;
}

std::string first_token(const std::string& pointer) {
  if (pointer.empty()) return pointer;
  return pointer.substr(1, pointer.find('/', 1) - 1);
}

}  // namespace capstan
