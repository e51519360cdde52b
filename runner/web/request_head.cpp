#include "runner/web/request_head.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>

#include "runner/web/request_target.hpp"

namespace capstan {
namespace {

using httplib::Request;
using std::string_view;
using Refusal = std::optional<Response>;

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

/// Control characters could hide a request in another one, or forge a line of a log.
bool has_control_characters(string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7f; });
}

string_view trimmed(string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Returns the first line and removes it from the text, with its line end.
string_view take_line(string_view& text) {
  const auto end = text.find("\r\n");
  const string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 2);
  return line;
}

Refusal parse_target(string_view target, Request& request) {
  request.target = target;
  if (target.front() != '/') return bad_request("the target must be a path");
  if (target.find('#') != target.npos) return bad_request("a fragment is not sent to a server");
  const auto mark = std::min(target.find('?'), target.size());
  request.path = target.substr(0, mark);
  if (request.path.size() > kMaxPath)
    return problem(414, "URI too long", "paths have at most 1000 characters");
  if (!percent_decoded(target))
    return bad_request("a % in the target is not followed by two hexadecimal digits");
  if (has_control_characters(*percent_decoded(request.path)))
    return bad_request("the path has a control character");
  if (mark < target.size()) request.params = parse_query(target.substr(mark + 1));
  return std::nullopt;
}

Refusal parse_request_line(string_view line, Request& request) {
  constexpr std::array<string_view, 7> kMethods = {"GET",   "HEAD",   "POST",   "PUT",
                                                   "PATCH", "DELETE", "OPTIONS"};
  constexpr const char* kExpected = "the first line must be METHOD TARGET VERSION";
  const auto first = line.find(' ');
  const auto last = line.rfind(' ');
  if (first == line.npos || first == last) return bad_request(kExpected);
  const string_view method = line.substr(0, first);
  const string_view target = line.substr(first + 1, last - first - 1);
  const string_view version = line.substr(last + 1);
  if (!is_token(method) || !is_visible(target) || !version.starts_with("HTTP/"))
    return bad_request(kExpected);
  if (version != "HTTP/1.1" && version != "HTTP/1.0")
    return problem(505, "HTTP version not supported", "this server speaks HTTP/1.1");
  request.method = method;
  if (std::find(kMethods.begin(), kMethods.end(), method) == kMethods.end())
    return problem(501, "Not implemented", "there is no such method here");
  if (line.size() > kMaxLine) return problem(414, "URI too long", "the first line has at most 8190 bytes");
  return parse_target(target, request);
}

Refusal parse_field(string_view line, Request& request) {
  constexpr std::size_t kMaxFields = 100;
  const auto colon = line.find(':');
  if (colon == line.npos || !is_token(line.substr(0, colon)))
    return bad_request("a header line must be NAME: VALUE");
  if (line.size() > kMaxLine) return bad_request("a header line has at most 8190 bytes");
  if (request.headers.size() == kMaxFields)
    return problem(431, "Request header fields too large", "there are more than 100 header lines");
  request.headers.emplace(line.substr(0, colon), trimmed(line.substr(colon + 1)));
  return std::nullopt;
}

/// Refuses a head in which one of these fields is given twice: parsers differ in which of the two they use.
Refusal refuse_duplicates(const Request& request) {
  for (const char* name : {"Content-Length", "Transfer-Encoding", "Host", "Authorization", "Origin",
                           "Content-Type", "Idempotency-Key", "If-None-Match", "Last-Event-ID", "Expect"})
    if (request.get_header_value_count(name) > 1)
      return bad_request("the header " + std::string(name) + " stands twice");
  if (!request.has_header("Host")) return bad_request("the header Host is missing");
  if (request.has_header("Content-Length") && request.has_header("Transfer-Encoding"))
    return bad_request("the length is given both as Content-Length and by Transfer-Encoding");
  return std::nullopt;
}

/// A length consists of digits alone: no sign, no list, not empty.
Refusal refuse_invalid_length(const Request& request) {
  if (!request.has_header("Content-Length")) return std::nullopt;
  const std::string text = request.get_header_value("Content-Length");
  const bool is_number =
      !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!is_number) return bad_request("Content-Length must be a number of bytes");
  return std::nullopt;
}

Refusal parse_lines(string_view text, Request& request) {
  if (auto refusal = parse_request_line(take_line(text), request)) return refusal;
  for (string_view line = take_line(text); !line.empty(); line = take_line(text))
    if (auto refusal = parse_field(line, request)) return refusal;
  if (!text.empty()) return bad_request("there is text after the head");
  if (auto refusal = refuse_duplicates(request)) return refusal;
  return refuse_invalid_length(request);
}

}  // namespace

ParsedHead parse_head(string_view text) {
  ParsedHead parsed;
  string_view rest = text;
  while (!rest.empty() && !parsed.refusal)
    if (has_control_characters(take_line(rest)))
      parsed.refusal = bad_request("there is a control character in the head");
  if (!parsed.refusal) parsed.refusal = parse_lines(text, parsed.request);
  return parsed;
}

std::size_t content_length(const Request& request) {
  const std::string text = request.get_header_value("Content-Length");
  std::size_t length = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), length);
  return read.ec == std::errc::result_out_of_range ? std::numeric_limits<std::size_t>::max() : length;
}

}  // namespace capstan
