#include "runner/cli/client.hpp"

#include <httplib.h>

#include "runner/web/bearer_token.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

[[noreturn]] void throw_refused(const httplib::Response& response) {
  const ordered_json body = ordered_json::parse(response.body, nullptr, false);
  if (!body.is_object() || !body.contains("detail"))
    throw std::runtime_error("the server answered with status " + std::to_string(response.status));
  Issues issues;
  if (body.contains("errors"))
    for (const ordered_json& error : body["errors"]) issues.push_back({error["pointer"], error["detail"]});
  throw Refused(response.status, body["detail"], issues);
}

std::string why_unreachable(httplib::Error error, const std::string& server) {
  if (error == httplib::Error::SSLServerVerification)
    return "the certificate of " + server +
           " is not trusted, or is another one's\nA certificate that this machine does not know is named "
           "with:  "
           "SSL_CERT_FILE=FILE";
  return "no server answers at " + server + " (" + httplib::to_string(error) +
         ")\nStart one with:  capstan serve\nor say where it is with:  --server URL";
}

std::string body_of(const httplib::Result& result, const std::string& server) {
  if (!result) throw Unreachable(why_unreachable(result.error(), server));
  if (result->status >= 300) throw_refused(*result);
  return result->body;
}

ordered_json content(const httplib::Result& result, const std::string& server) {
  return ordered_json::parse(body_of(result, server));
}

std::unique_ptr<httplib::ClientImpl> http_client(const ServerUrl& url) {
  auto client = url.is_secure ? std::make_unique<httplib::SSLClient>(url.host, url.port)
                              : std::make_unique<httplib::ClientImpl>(url.host, url.port);
  httplib::Headers headers = {{"Host", url.authority()}};
  if (const auto token = token_of_environment()) headers.emplace("Authorization", "Bearer " + *token);
  client->set_default_headers(headers);
  client->set_read_timeout(60);
  return client;
}

}  // namespace

Client::Client(const std::string& server) : server_(server) {
  const ServerUrl url = parse_server_url(server);
  prefix_ = url.prefix;
  http_ = http_client(url);
}

Client::~Client() = default;

ordered_json Client::get(const std::string& path, const std::multimap<std::string, std::string>& query) {
  return content(http_->Get(prefix_ + path, query, httplib::Headers()), server_);
}

std::string Client::get_file(const std::string& path, const std::multimap<std::string, std::string>& query) {
  return body_of(http_->Get(prefix_ + path, query, httplib::Headers()), server_);
}

void Client::for_each_page(const std::string& path, const std::string& list,
                           const std::function<void(const ordered_json& items)>& use) {
  const char* const separator = path.find('?') == std::string::npos ? "?" : "&";
  ordered_json page = get(path);
  use(page[list]);
  while (page["next"].is_string()) {
    page = get(path + separator + "after=" + page["next"].get<std::string>());
    use(page[list]);
  }
}

ordered_json Client::get_all(const std::string& path, const std::string& list) {
  ordered_json all = ordered_json::array();
  for_each_page(path, list, [&](const ordered_json& items) {
    for (const ordered_json& item : items) all.push_back(item);
  });
  return all;
}

ordered_json Client::post(const std::string& path, const std::string& body) {
  return content(http_->Post(prefix_ + path, body, "application/json"), server_);
}

ordered_json Client::remove(const std::string& path) {
  return content(http_->Delete(prefix_ + path), server_);
}

}  // namespace capstan
