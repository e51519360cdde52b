#pragma once
// The state of a run in memory: named arrays of numbers, which a checkpoint stores.
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace capstan {

class StateArchive {
 public:
  StateArchive() = default;
  StateArchive(StateArchive&&) = default;  // not copied: the views of a copy would point into the original
  StateArchive& operator=(StateArchive&&) = default;

  /// Keeps a view, because the populations of a lattice are too large to copy. The data must outlive the
  /// archive.
  void put_view(const std::string& name, std::span<const double> data) { entries_[name] = {{}, data}; }

  void put(const std::string& name, std::vector<double> data) {
    Entry& entry = entries_[name];
    entry.owned = std::move(data);
    entry.view = entry.owned;
  }

  void put(const std::string& name, double number) { put(name, std::vector<double>{number}); }

  bool contains(const std::string& name) const { return entries_.contains(name); }

  /// The array of that name. Throws std::runtime_error if there is none.
  std::span<const double> get(const std::string& name) const {
    const auto found = entries_.find(name);
    if (found == entries_.end()) throw std::runtime_error("checkpoint has no entry \"" + name + "\"");
    return found->second.view;
  }

  /// The first number of the array.
  double number(const std::string& name) const { return get(name).front(); }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& [name, entry] : entries_) all.push_back(name);
    return all;
  }

 private:
  struct Entry {
    std::vector<double> owned;  ///< empty if the data belongs to the caller
    std::span<const double> view;
  };
  std::map<std::string, Entry> entries_;
};

}  // namespace capstan
