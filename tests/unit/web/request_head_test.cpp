#include "runner/web/request_head.hpp"

#include <gtest/gtest.h>

#include "runner/web/request_restrictions.hpp"

namespace capstan {
namespace {

/// A POST with these further header lines.
ParsedHead post(const std::string& lines) {
  return parse_head("POST /v1/studies HTTP/1.1\r\nHost: localhost\r\n" + lines + "\r\n");
}

/// Status of the refusal; 0 if the head is accepted.
int status_of(const ParsedHead& parsed) {
  if (parsed.refusal) return parsed.refusal->status;
  const auto refusal = refuse_unsupported(parsed.request);
  return refusal ? refusal->status : 0;
}

int status_of_first_line(const std::string& line) {
  return status_of(parse_head(line + "\r\nHost: localhost\r\n\r\n"));
}

TEST(RequestHead, IsParsedUnchanged) {
  const ParsedHead parsed =
      post("content-TYPE:\t application/json; charset=utf-8 \r\nContent-Length: 12\r\n");
  ASSERT_FALSE(parsed.refusal);
  EXPECT_EQ(parsed.request.method, "POST");
  EXPECT_EQ(parsed.request.target, "/v1/studies");
  EXPECT_EQ(parsed.request.get_header_value("Content-Type"), "application/json; charset=utf-8");
  EXPECT_EQ(content_length(parsed.request), 12u);
  EXPECT_EQ(status_of(parsed), 0);
}

TEST(RequestHead, EscapesInValuesAreNotDecoded) {
  EXPECT_EQ(post("Idempotency-Key: a%0d%0ab\r\n").request.get_header_value("Idempotency-Key"), "a%0d%0ab");
}

TEST(RequestHead, BrokenEscapesAndControlCharactersInThePathAreRefused) {
  for (const char* target : {"/v1/%", "/v1/%4", "/v1/%zz", "/v1/%+1", "/a?b=%4", "/v1/studies/%1b[2J",
                             "/v1/studies/a%0d%0ab", "/v1/%00", "/v1/%7f"})
    EXPECT_EQ(status_of_first_line("GET " + std::string(target) + " HTTP/1.1"), 400) << target;
  EXPECT_EQ(status_of_first_line("GET /v1/studies/a%2Fb%20c?d=%C3%A9 HTTP/1.1"), 0);
}

TEST(RequestHead, WithAnAmbiguousLengthIsRefused) {
  for (const char* lines : {"Content-Length: 5\r\nTransfer-Encoding: chunked\r\n",
                            "Transfer-Encoding: chunked\r\nContent-Length: 5\r\n",
                            "Content-Length: 5\r\nContent-Length: 5\r\n",
                            "Content-Length: 5\r\ncontent-length: 6\r\n",
                            "Content-Length: 5, 5\r\n",
                            "Content-Length: -1\r\n",
                            "Content-Length: +5\r\n",
                            "Content-Length: 0x5\r\n",
                            "Content-Length: 5 5\r\n",
                            "Content-Length:\r\n",
                            "Content-Length: %35\r\n",
                            "Content-Length : 5\r\n",
                            " Content-Length: 5\r\n",
                            "A: b\r\n Content-Length: 5\r\n",
                            "Content-Length: 5\nTransfer-Encoding: chunked\r\n",
                            "Content-Length: 5\rA: b\r\n",
                            "Transfer-Encoding: a\r\nTransfer-Encoding: chunked\r\n",
                            "Content\tLength: 5\r\n",
                            "Content-Length\r\n",
                            ": 5\r\n"})
    EXPECT_EQ(status_of(post(lines)), 400) << lines;
}

TEST(RequestHead, WithANulIsRefused) {
  const std::string nul(1, '\0');
  EXPECT_EQ(status_of(post("A: b" + nul + "c\r\n")), 400);
  EXPECT_EQ(status_of_first_line("GET /" + nul + " HTTP/1.1"), 400);
}

TEST(RequestHead, OfAChunkedBodyIsRefusedInEverySpelling) {
  for (const char* lines : {"Transfer-Encoding: chunked\r\n", "TRANSFER-ENCODING: Chunked\r\n",
                            "Transfer-Encoding: xchunked\r\n", "Transfer-Encoding: chunke%64\r\n",
                            "Transfer-Encoding: gzip, chunked\r\n", "Transfer-Encoding: identity\r\n"})
    EXPECT_EQ(status_of(post(lines)), 411) << lines;
}

TEST(RequestHead, OfABodyThatIsTooLargeIsRefused) {
  const std::string json = "Content-Type: application/json\r\n";
  EXPECT_EQ(status_of(post(json + "Content-Length: 1048576\r\n")), 0);
  for (const char* length : {"1048577", "4294967296", "18446744073709551616", "99999999999999999999999999"})
    EXPECT_EQ(status_of(post(json + "Content-Length: " + length + "\r\n")), 413) << length;
}

TEST(RequestHead, OfABodyThatIsNotPlainJsonIsRefused) {
  for (const char* lines :
       {"Content-Length: 5\r\n", "Content-Length: 5\r\nContent-Type: text/plain\r\n",
        "Content-Length: 5\r\nContent-Type: multipart/form-data; boundary=a\r\n",
        "Content-Length: 5\r\nContent-Type: application/x-www-form-urlencoded\r\n",
        "Content-Type: application/json\r\nContent-Encoding: gzip\r\nContent-Length: 5\r\n"})
    EXPECT_EQ(status_of(post(lines)), 415) << lines;
}

TEST(RequestHead, WithARangeOrAnotherExpectationIsRefused) {
  EXPECT_EQ(status_of(post("Range: bytes=0-1\r\n")), 416);
  EXPECT_EQ(status_of(post("Expect: 200-ok\r\n")), 417);
  EXPECT_EQ(status_of(post("Expect: 100-continue\r\n")), 0);
}

TEST(RequestHead, WithoutExactlyOneHostIsRefused) {
  EXPECT_EQ(status_of(parse_head("GET / HTTP/1.1\r\n\r\n")), 400);
  EXPECT_EQ(status_of(post("Host: localhost\r\n")), 400);
}

TEST(RequestHead, WithAnInvalidFirstLineIsRefused) {
  for (const char* line :
       {"", "GET", "GET /", "GET / ", " / HTTP/1.1", "GET  / HTTP/1.1", "GET / HTTP/1.1 ",
        "GET /a b HTTP/1.1", "GET http://localhost/ HTTP/1.1", "GET * HTTP/1.1", "GET /# HTTP/1.1",
        "GET /\xc3\xa4 HTTP/1.1", "G@T / HTTP/1.1", "GET / HTP/1.1", "GET\t/\tHTTP/1.1"})
    EXPECT_EQ(status_of_first_line(line), 400) << line;
  EXPECT_EQ(status_of_first_line("GET / HTTP/2.0"), 505);
  EXPECT_EQ(status_of_first_line("GET / HTTP/1.11"), 505);
  for (const char* method : {"TRACE", "CONNECT", "PRI", "get", "BREW"})
    EXPECT_EQ(status_of_first_line(std::string(method) + " / HTTP/1.1"), 501) << method;
}

TEST(RequestHead, WithALongPathLongLineOrManyLinesIsRefused) {
  EXPECT_EQ(status_of_first_line("GET /" + std::string(999, 'a') + " HTTP/1.1"), 0);
  EXPECT_EQ(status_of_first_line("GET /" + std::string(1000, 'a') + " HTTP/1.1"), 414);
  std::string lines;
  for (int i = 0; i < 99; ++i) lines += "A: b\r\n";
  EXPECT_EQ(status_of(post(lines)), 0);
  EXPECT_EQ(status_of(post(lines + "A: b\r\n")), 431);
  EXPECT_EQ(status_of_first_line("GET /?" + std::string(kMaxLine - 15, 'a') + " HTTP/1.1"), 0);
  EXPECT_EQ(status_of_first_line("GET /?" + std::string(kMaxLine - 14, 'a') + " HTTP/1.1"), 414);
  EXPECT_EQ(status_of(post("A: " + std::string(kMaxLine - 3, 'a') + "\r\n")), 0);
  EXPECT_EQ(status_of(post("A: " + std::string(kMaxLine - 2, 'a') + "\r\n")), 400);
}

}  // namespace
}  // namespace capstan
