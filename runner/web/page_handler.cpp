#include "runner/web/handlers.hpp"
#include "runner/web/page_files.hpp"

namespace capstan {
namespace {

/// The page loads and asks nothing but this server, and runs no script or style that is not a file of it.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

}  // namespace

/// Browsers keep the files and ask each time whether they have changed: another version of the program has
/// other files.
Response get_page_file(Service&, const httplib::Request& request, const std::string&) {
  const PageFile* const file = find_page_file(request.path);
  if (!file) return problem(404, "Not found", "the page has no file " + request.path);
  return {200,
          std::string(file->content_type),
          std::string(file->text),
          {{"Content-Security-Policy", kContentSecurityPolicy},
           {"Referrer-Policy", "no-referrer"},
           {"Cache-Control", "no-cache"}}};
}

}  // namespace capstan
