#include "runner/slurm/slurm_words.hpp"

#include <map>

namespace capstan {

std::string why_it_waits(const ListedTask& task) {
  static const std::map<std::string, std::string> kWords = {
      {"None", "Slurm has not looked at it yet"},
      {"Priority", "jobs of higher priority are before it"},
      {"Resources", "no node has enough free cores and memory"},
      {"ReqNodeNotAvail", "nodes that it needs are down, drained or reserved"},
      {"Nodes required for job are DOWN", "nodes that it needs are down, drained or reserved"},
      {"BadConstraints", "no node can give what it asks for"},
      {"NodeDown", "a node that it needs is down"},
      {"PartitionDown", "the partition is down"},
      {"PartitionInactive", "the partition is inactive"},
      {"PartitionNodeLimit", "the partition has not the nodes that it asks for"},
      {"PartitionTimeLimit", "it asks for more time than the partition allows: serve with a shorter --time"},
      {"PartitionConfig", "the partition has not what it asks for"},
      {"JobArrayTaskLimit", "the array may not have more tasks running"},
      {"JobHeldUser", "the user holds it: scontrol release"},
      {"JobHeldAdmin", "an administrator holds it"},
      {"BeginTime", "it may not begin yet"},
      {"Dependency", "it depends on another job"},
      {"Licenses", "it waits for a license"},
      {"Reservation", "it waits for its reservation"},
      {"InvalidAccount", "its account is invalid: serve with another --account"},
      {"InvalidQOS", "its quality of service is invalid"}};
  const std::string reason = task.reason.substr(0, task.reason.find(','));
  if (const auto found = kWords.find(reason); found != kWords.end()) return found->second;
  const bool is_limit = reason.starts_with("QOS") || reason.starts_with("Assoc") || reason.starts_with("Max");
  return (is_limit ? "a limit of its account or quality of service is reached (" : "(") + task.reason + ")";
}

std::string how_it_ended(const ListedTask& task) {
  static const std::map<std::string, std::string> kWords = {
      {"BOOT_FAIL", "its node did not boot"},
      {"CANCELLED", "it was cancelled in Slurm"},
      {"COMPLETED", "its job ended before it"},
      {"DEADLINE", "its deadline passed"},
      {"FAILED", "its job failed"},
      {"NODE_FAIL", "its node failed"},
      {"OUT_OF_MEMORY", "it took more memory than was asked for"},
      {"PREEMPTED", "another job took its place"},
      {"TIMEOUT", "the time limit of its job passed"}};
  const auto found = kWords.find(task.state);
  const std::string words = found == kWords.end() ? "Slurm says " + task.state : found->second;
  const std::string node = task.node.empty() ? "" : " on node " + task.node;
  const bool has_reason = !task.reason.empty() && task.reason != "None";
  return words + " (job " + task.id + node + (has_reason ? ", " + task.reason : "") + ")";
}

}  // namespace capstan
