#include "runner/web/head.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "runner/web/target.hpp"

namespace capstan {
namespace {

using std::string_view;

Response bad_request(const std::string& detail) { return problem(400, "Bad request", detail); }

bool is_token(string_view text) {  // RFC 9110, 5.6.2
  const auto allowed = [](unsigned char c) {
    constexpr string_view kMarks = "!#$%&'*+-.^_`|~";
    return c < 128 && (std::isalnum(c) || kMarks.find(static_cast<char>(c)) != kMarks.npos);
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), allowed);
}

bool is_visible(string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c > 0x20 && c < 0x7f; });
}

/// Control characters are how one request hides in another, or a line in a log.
bool has_control_characters(string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7f; });
}

string_view without_space_around(string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The text up to the next line end, which is taken off with it.
string_view take_line(string_view& text) {
  const auto end = text.find("\r\n");
  const string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 2);
  return line;
}

std::optional<Response> read_target(string_view target, Head& head) {
  head.target = target;
  if (target.front() != '/') return bad_request("the target must be a path");
  if (target.find('#') != target.npos) return bad_request("a fragment is not sent to a server");
  const string_view path = target.substr(0, target.find('?'));
  if (path.size() > kMaxPath) return problem(414, "URI too long", "paths have at most 1000 characters");
  if (!percent_decoded(target))
    return bad_request("a % in the target is not followed by two hexadecimal digits");
  if (has_control_characters(*percent_decoded(path))) return bad_request("the path has a control character");
  return std::nullopt;
}

std::optional<Response> read_request_line(string_view line, Head& head) {
  constexpr std::array<string_view, 7> kMethods = {"GET",   "HEAD",   "POST",   "PUT",
                                                   "PATCH", "DELETE", "OPTIONS"};
  const auto first = line.find(' ');
  const auto last = line.rfind(' ');
  if (first == line.npos || first == last) return bad_request("the first line is no METHOD TARGET VERSION");
  const string_view method = line.substr(0, first);
  const string_view target = line.substr(first + 1, last - first - 1);
  const string_view version = line.substr(last + 1);
  if (!is_token(method) || !is_visible(target) || !version.starts_with("HTTP/"))
    return bad_request("the first line is no METHOD TARGET VERSION");
  if (version != "HTTP/1.1" && version != "HTTP/1.0")
    return problem(505, "HTTP version not supported", "this server speaks HTTP/1.1");
  head.method = method;
  if (std::find(kMethods.begin(), kMethods.end(), method) == kMethods.end())
    return problem(501, "Not implemented", "there is no such method here");
  return read_target(target, head);
}

std::optional<Response> read_field(string_view line, Head& head) {
  constexpr std::size_t kMaxFields = 100;
  const auto colon = line.find(':');
  if (colon == line.npos || !is_token(line.substr(0, colon)))
    return bad_request("a header line is no NAME: VALUE");
  if (head.fields.size() == kMaxFields)
    return problem(431, "Request header fields too large", "there are more than 100 header lines");
  head.fields.emplace_back(line.substr(0, colon), without_space_around(line.substr(colon + 1)));
  return std::nullopt;
}

/// Two of these would leave it to the reader which one counts.
std::optional<Response> refuse_duplicates(const Head& head) {
  for (const char* name : {"Content-Length", "Transfer-Encoding", "Host", "Authorization", "Origin",
                           "Content-Type", "Idempotency-Key", "If-None-Match", "Last-Event-ID", "Expect"})
    if (head.count(name) > 1) return bad_request("the header " + std::string(name) + " stands twice");
  if (head.count("Host") == 0) return bad_request("the header Host is missing");
  if (head.count("Content-Length") + head.count("Transfer-Encoding") > 1)
    return bad_request("the length is given both as Content-Length and by Transfer-Encoding");
  return std::nullopt;
}

/// Digits alone: neither a sign nor a list nor an empty value is a length.
std::optional<Response> read_length(Head& head) {
  if (head.count("Content-Length") == 0) return std::nullopt;
  const std::string text = head.value("Content-Length");
  const bool is_number = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 128 && std::isdigit(c);
  });
  if (!is_number) return bad_request("Content-Length is no number of bytes");
  const auto read = std::from_chars(text.data(), text.data() + text.size(), head.content_length);
  if (read.ec != std::errc()) head.content_length = static_cast<std::size_t>(-1);  // too large for any type
  return std::nullopt;
}

std::optional<Response> read_head(string_view text, Head& head) {
  if (auto refusal = read_request_line(take_line(text), head)) return refusal;
  for (string_view line = take_line(text); !line.empty(); line = take_line(text))
    if (auto refusal = read_field(line, head)) return refusal;
  if (!text.empty()) return bad_request("there is text after the head");
  if (auto refusal = refuse_duplicates(head)) return refusal;
  return read_length(head);
}

bool has_media_type(const Head& head, string_view wanted) {
  const std::string type = head.value("Content-Type");
  return equal_ignoring_case(without_space_around(string_view(type).substr(0, type.find(';'))), wanted);
}

}  // namespace

bool equal_ignoring_case(string_view a, string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string Head::value(string_view name) const {
  for (const auto& [key, value] : fields)
    if (equal_ignoring_case(key, name)) return value;
  return "";
}

std::size_t Head::count(string_view name) const {
  return static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), [&](const auto& field) {
    return equal_ignoring_case(field.first, name);
  }));
}

ParsedHead parse_head(string_view text) {
  ParsedHead parsed;
  string_view rest = text;
  while (!rest.empty() && !parsed.refusal)
    if (has_control_characters(take_line(rest)))
      parsed.refusal = bad_request("there is a control character in the head");
  if (!parsed.refusal) parsed.refusal = read_head(text, parsed.head);
  return parsed;
}

std::optional<Response> refuse_hazards(const Head& head) {
  if (head.count("Transfer-Encoding") > 0)
    return problem(411, "Length required", "send the body with a Content-Length, not in chunks");
  if (head.content_length > kMaxBody) return problem(413, "Content too large", "a body has at most 1 MiB");
  if (head.count("Content-Encoding") > 0)
    return problem(415, "Unsupported media type", "send the body uncompressed");
  if (head.content_length > 0 && !has_media_type(head, "application/json"))
    return problem(415, "Unsupported media type", "send JSON, as Content-Type: application/json");
  if (head.count("Range") > 0) return problem(416, "Range not satisfiable", "answers come as a whole");
  if (head.count("Expect") > 0 && !equal_ignoring_case(head.value("Expect"), "100-continue"))
    return problem(417, "Expectation failed", "nothing but 100-continue can be expected");
  return std::nullopt;
}

}  // namespace capstan
