// What every client of the service needs: an ORB set up for it, a place for callbacks, a model's bytes.
#ifndef MECH_CLIENT_CONNECTION_HH
#define MECH_CLIENT_CONNECTION_HH

#include "mechservice.hh"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>

namespace ms = mechservice;

// An address of one's own: the server tells clients' connections apart by the address each client
// states. A random loopback address keeps two clients from stating the same one.
inline std::string ownAddress() {
  std::random_device seed;
  std::uniform_int_distribution<int> byte(1, 254);
  return "giop:tcp:127." + std::to_string(byte(seed)) + "." +
         std::to_string(byte(seed)) + "." + std::to_string(byte(seed)) + ":";
}

inline CORBA::ORB_ptr startOrb(int& argc, char** argv, const std::string& address = ownAddress()) {
  const char* options[][2] = {
      {"nativeCharCodeSet", "UTF-8"},         // the default, Latin-1, refuses most names
      {"offerBiDirectionalGIOP", "1"},        // callbacks over our own connection ...
      {"clientTransportRule", "* bidir,tcp"}, // ... for every server
      {"giopMaxMsgSize", "67108864"},         // 64 MiB: JARs are larger than the default 2 MB
      {"endPoint", address.c_str()},
      {nullptr, nullptr}};
  return CORBA::ORB_init(argc, argv, "", options);
}

// The POA our callbacks live in: reachable over our own connections, one call at a time, in order.
inline PortableServer::POA_ptr callbackPoa(CORBA::ORB_ptr orb) {
  CORBA::Object_var object = orb->resolve_initial_references("RootPOA");
  PortableServer::POA_var root = PortableServer::POA::_narrow(object);
  PortableServer::POAManager_var manager = root->the_POAManager();
  manager->activate();
  CORBA::Any both;
  both <<= BiDirPolicy::BOTH;
  CORBA::PolicyList policies(2);
  policies.length(2);
  policies[0] = orb->create_policy(BiDirPolicy::BIDIRECTIONAL_POLICY_TYPE, both);
  policies[1] = root->create_thread_policy(PortableServer::SINGLE_THREAD_MODEL);
  return root->create_POA("callbacks", manager, policies);
}

inline ms::ModelFile readModel(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw std::invalid_argument(path + ": cannot be read");
  }
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  ms::ModelFile file;
  file.fileName = path.substr(path.find_last_of('/') + 1).c_str();
  file.content.length(bytes.size());
  std::copy(bytes.begin(), bytes.end(), file.content.get_buffer());
  return file;
}

#endif
