#include "tests/fuzz/mutation.hpp"

#include <algorithm>

namespace capstan {
namespace {

std::size_t below(std::size_t end, std::mt19937& random) { return random() % std::max<std::size_t>(1, end); }

const std::string& fragment(std::mt19937& random) {
  static const std::vector<std::string> fragments = {"\r\n",
                                                     "\r\n\r\n",
                                                     "\n",
                                                     std::string(1, '\0'),
                                                     "%00",
                                                     "%0d%0a",
                                                     "Content-Length: ",
                                                     "Content-Length: 5\r\n",
                                                     "Content-Length: -1\r\n",
                                                     "Transfer-Encoding: chunked\r\n",
                                                     "Content-Encoding: gzip\r\n",
                                                     "Range: bytes=0-\r\n",
                                                     "Expect: 100-continue\r\n",
                                                     "Host: localhost\r\n",
                                                     "Origin: null\r\n",
                                                     "GET /healthz HTTP/1.1\r\n",
                                                     "0\r\n\r\n",
                                                     "18446744073709551616",
                                                     "-1",
                                                     "1e999",
                                                     "[[[[[[[[",
                                                     "{\"",
                                                     "?after=0&limit=0",
                                                     "/../",
                                                     "\xff\xfe",
                                                     "\\u0000"};
  return fragments[below(fragments.size(), random)];
}

void change(std::string& text, const std::vector<std::string>& samples, std::mt19937& random) {
  const std::size_t at = below(text.size() + 1, random);
  const std::size_t length = below(std::min<std::size_t>(40, text.size() - at + 1), random);
  switch (random() % 7) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << (random() % 8)));
      break;
    case 1:
      text.insert(at, 1, static_cast<char>(random()));
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, text.substr(at, length));
      break;
    case 4:
      text.insert(at, fragment(random));
      break;
    case 5:
      text.resize(at);
      break;
    default: {
      const std::string& other = samples[below(samples.size(), random)];
      text = text.substr(0, at) + other.substr(below(other.size(), random));
    }
  }
}

}  // namespace

std::string mutated(const std::vector<std::string>& samples, std::mt19937& random) {
  std::string text = samples[below(samples.size(), random)];
  for (std::size_t changes = below(5, random); changes > 0; --changes) change(text, samples, random);
  return text;
}

}  // namespace capstan
