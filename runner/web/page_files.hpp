#pragma once
// The page that the server shows in a browser: the files of runner/web/page, embedded by the build.
#include <span>
#include <string_view>

namespace capstan {

struct PageFile {
  std::string_view path;  ///< "/" for index.html, "/page/page.js"
  std::string_view content_type;
  std::string_view text;
};

/// The file at a path; null if the page has none there.
const PageFile* find_page_file(std::string_view path);

std::span<const PageFile> page_files();

}  // namespace capstan
