// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/master_watch.hpp"

#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/publication.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>

#include <chrono>
#include <optional>

namespace mbncc::nodelets {
namespace {

using XmlRpc::XmlRpcValue;

constexpr std::chrono::seconds kInterval{1};

/// The registrations of this process at the master.
struct Registrations {
  bool known = false;
  std::vector<std::string> services;
};

XmlRpcValue arguments(const std::vector<std::string>& texts) {
  XmlRpcValue values;
  values.setSize(static_cast<int>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i) values[static_cast<int>(i)] = texts[i];
  return values;
}

/// Calls a method of the master. Returns none if the master does not answer, or if the process is
/// shutting down: it unregisters itself then and must not be registered again.
std::optional<XmlRpcValue> ask_master(const std::string& method,
                                      const std::vector<std::string>& texts) {
  XmlRpcValue response, payload;
  if (ros::isShuttingDown() ||
      !ros::master::execute(method, arguments(texts), response, payload, false))
    return {};
  return payload;
}

/// Names of the rows [name, [node, ...]] of the master's state that list this node.
std::vector<std::string> rows_of_this_node(XmlRpcValue rows) {
  std::vector<std::string> names;
  for (int i = 0; i < rows.size(); ++i)
    for (int k = 0; k < rows[i][1].size(); ++k)
      if (std::string(rows[i][1][k]) == ros::this_node::getName())
        names.push_back(std::string(rows[i][0]));
  return names;
}

std::optional<Registrations> registrations() {
  auto state = ask_master("getSystemState", {ros::this_node::getName()});
  if (!state) return {};
  // The state lists publishers, subscribers and services. Every node publishes /rosout.
  return Registrations{!rows_of_this_node((*state)[0]).empty(), rows_of_this_node((*state)[2])};
}

/// Sends this process the list of a topic's publishers, as the master would.
void update_publishers(const std::string& topic, const XmlRpcValue& publishers) {
  std::string host;
  std::uint32_t port = 0;
  const std::string self = ros::XMLRPCManager::instance()->getServerURI();
  if (!ros::network::splitURI(self, host, port)) return;
  auto* client = ros::XMLRPCManager::instance()->getXMLRPCClient(host, static_cast<int>(port), "/");
  XmlRpcValue request = arguments({"/master", topic}), response;
  request[2] = publishers;
  client->execute("publisherUpdate", request, response);
  ros::XMLRPCManager::instance()->releaseXMLRPCClient(client);
}

void register_topics() {
  const std::string name = ros::this_node::getName();
  const std::string self = ros::XMLRPCManager::instance()->getServerURI();
  const auto topics = ros::TopicManager::instance();
  ros::V_string advertised, subscribed;
  topics->getAdvertisedTopics(advertised);
  for (const auto& topic : advertised)
    if (const auto publication = topics->lookupPublication(topic))
      ask_master("registerPublisher", {name, topic, publication->getDataType(), self});
  topics->getSubscribedTopics(subscribed);
  for (const auto& topic : subscribed) {
    const auto publishers = ask_master("registerSubscriber", {name, topic, "*", self});
    // An empty list would close connections that outlived the master.
    if (publishers && publishers->size() > 0) update_publishers(topic, *publishers);
  }
}

/// The URI for service calls. Call this only while roscpp runs, because it has no port before and
/// afterwards.
std::string service_uri() {
  return "rosrpc://" + ros::network::getHost() + ":" +
         std::to_string(ros::ConnectionManager::instance()->getTCPPort());
}

void register_services(const std::vector<std::string>& services, const std::string& uri) {
  for (const auto& service : services)
    ask_master("registerService", {ros::this_node::getName(), service, uri,
                                   ros::XMLRPCManager::instance()->getServerURI()});
}

}  // namespace

std::shared_ptr<MasterWatch> MasterWatch::shared() {
  static std::mutex mutex;
  static std::weak_ptr<MasterWatch> watch;
  const std::lock_guard<std::mutex> lock(mutex);
  auto held = watch.lock();
  if (!held) watch = held = std::make_shared<MasterWatch>();
  return held;
}

MasterWatch::MasterWatch() : watcher_([this] { watch(); }) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  watcher_.join();
}

/// Waits for one interval. Returns false if the watch ends.
bool MasterWatch::wait() {
  std::unique_lock<std::mutex> lock(mutex_);
  return !changed_.wait_for(lock, kInterval, [this] { return stopped_; });
}

void MasterWatch::watch() {
  while (wait() && !ros::isShuttingDown()) {
    const auto now = registrations();
    if (!now || ros::isShuttingDown()) continue;
    if (now->known) {
      services_ = now->services;
      if (service_uri_.empty()) service_uri_ = service_uri();
      continue;
    }
    ROS_WARN(
        "the ROS master was restarted; registering again; parameters keep the values read at "
        "startup");
    register_topics();
    register_services(services_, service_uri_);
  }
}

}  // namespace mbncc::nodelets
