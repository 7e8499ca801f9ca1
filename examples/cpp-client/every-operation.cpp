// Calls every operation of the contract once, and says which: the proof that the contract is whole
// in another language and another ORB.
//
//   every-operation PORT MODEL.xml ROBOT.urdf
//
// On PORT of the loopback interface it stands as a server that has a registry for hosts and nothing
// else. Start a server and a host that knows both:
//
//   mech server --port 15000
//   mech simhost --server 127.0.0.1:PORT,127.0.0.1:15000 --listen 127.0.0.1:0 --name far
//
// The host registers here, so its own interface can be called, which no client is ever given. What
// the host's registration needs is taken over to the other server, whose URL is read from standard
// input. Every operation is printed when it has come back: INTERFACE.OPERATION.

#include "connection.hh"

#include <omniORB4/omniInterceptors.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <set>
#include <thread>

using namespace std::chrono_literals;

std::mutex printing;

void done(const char* operation) {
  std::lock_guard<std::mutex> lock(printing);
  std::cout << operation << std::endl;
}

// Calls an operation and says so when it has come back.
#define CALL(INTERFACE, OPERATION, OBJECT, ...)                     \
  ([&]() -> decltype(auto) {                                        \
    ms::INTERFACE##_ptr object = (OBJECT);                          \
    struct Done {                                                   \
      ~Done() {                                                     \
        if (!std::uncaught_exceptions()) {                          \
          done(#INTERFACE "." #OPERATION);                          \
        }                                                           \
      }                                                             \
    } whenBack;                                                     \
    return object->OPERATION(__VA_ARGS__);                          \
  }())

void require(bool holds, const char* what) {
  if (!holds) {
    throw std::runtime_error(what);
  }
}

class Watcher : public POA_mechservice::IMechClient {
 public:
  void onStatus(const char*, ms::SimState, const char*) override { note("IMechClient.onStatus"); }
  void onProgress(const ms::Progress&) override { note("IMechClient.onProgress"); }
  void onMessages(const char*, const ms::DiagnosticSeq&) override { note("IMechClient.onMessages"); }
  void heartbeat() override { note("IMechClient.heartbeat"); }

  // Callbacks are oneway and come when they come.
  bool await(std::size_t kinds) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, 60s, [&] { return heard_.size() >= kinds; });
  }

 private:
  void note(const char* what) {
    std::lock_guard<std::mutex> lock(mutex_);
    if (heard_.insert(what).second) {
      done(what);
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<std::string> heard_;
};

class Registration : public POA_mechservice::HostRegistration {
 public:
  CORBA::ULong renewLease() override { return 60; }
  void destroy() override {}
};

// The registry that hosts find here.
class Registry : public POA_mechservice::HostRegistry {
 public:
  ms::HostRegistration_ptr registerHost(const ms::HostInfo& info, ms::MechSimHost_ptr host) override {
    std::lock_guard<std::mutex> lock(mutex_);
    info_ = info;
    host_ = ms::MechSimHost::_duplicate(host);
    registered_.notify_all();
    return registration_._this();
  }

  ms::MechSimHost_ptr awaitHost(ms::HostInfo& info) {
    std::unique_lock<std::mutex> lock(mutex_);
    require(registered_.wait_for(lock, 120s, [&] { return !CORBA::is_nil(host_); }), "no host came");
    info = info_;
    return ms::MechSimHost::_duplicate(host_);
  }

 private:
  std::mutex mutex_;
  std::condition_variable registered_;
  Registration registration_;
  ms::HostInfo info_;
  ms::MechSimHost_var host_;
};

// Says who it is, which is all that a host asks before it registers.
class Server : public POA_mechservice::MechServer {
 public:
  ms::ServerInfo* getInfo() override {
    ms::ServerInfo* info = new ms::ServerInfo;
    info->serverName = "every-operation";
    info->apiVersion = ms::API_VERSION;
    info->serverVersion = "0";
    return info;
  }
  ms::MechSim_ptr createSession(const char*, const char*, ms::IMechClient_ptr) override {
    throw ms::LimitExceeded("S-011", "no sessions here", "sessions", 0, 1);
  }
  ms::MechSim_ptr findSession(const char*) override { throw ms::NotFound("S-012", "no sessions here"); }
  ms::IMechSimRemote_ptr findSimulation(const char*) override {
    throw ms::NotFound("S-012", "no simulations here");
  }
  ms::ModelFile* importModel(const ms::ModelFile&, ms::DiagnosticSeq_out) override {
    throw ms::NotAvailable("S-017", "no import here");
  }
  ms::LimitSeq* limits() override { return new ms::LimitSeq; }
};

ms::NameValueSeq options(std::initializer_list<std::pair<const char*, const char*>> all) {
  ms::NameValueSeq options(all.size());
  options.length(all.size());
  CORBA::ULong i = 0;
  for (const auto& [key, text] : all) {
    options[i].key = key;
    options[i++].text = text;
  }
  return options;
}

void await(ms::IMechSimRemote_ptr run, ms::SimState wanted) {
  for (int i = 0; i < 6000; ++i) {
    ms::Progress_var progress = run->getProgress();
    if (progress->state == wanted) {
      return;
    }
    std::this_thread::sleep_for(10ms);
  }
  throw std::runtime_error("the simulation does not get there");
}

void readRows(ms::IMechSimRemote_ptr run) {
  ms::ResultCursor_var cursor = CALL(IMechSimRemote, openResults, run, ms::StringSeq());
  ms::ChannelSeq_var channels = CALL(ResultCursor, channels, cursor);
  require(channels->length() == 11, "the pendulum has 11 columns");
  ms::ResultBlock_var block;
  do {
    CALL(ResultCursor, nextBlock, cursor, 100, 1000, block.out());
  } while (!block->endOfData);
  CALL(ResultCursor, seekRow, cursor, 0);
  cursor->nextBlock(1, 0, block.out());
  require(block->firstRow == 0 && block->rowCount == 1, "the first row comes again");
  CALL(Leased, renewLease, cursor.in());
  CALL(Leased, destroy, cursor.in());
}

void steer(ms::MechSim_ptr session) {
  ms::IMechSimRemote_var run =
      CALL(MechSim, createSimulation, session, options({{"t-end", "1e6"}, {"t-step", "1e3"}}), ms::IMechClient::_nil());
  ms::ParameterSeq_var parameters = CALL(IMechSimRemote, parameters, run);
  CALL(IMechSimRemote, setParameters, run, ms::NameValueSeq());
  CORBA::String_var id = CALL(IMechSimRemote, simId, run);
  require(std::string(id).size() == 36, "a simulation's identity is a UUID");
  ms::ChannelSeq_var states = CALL(IMechSimRemote, stateChannels, run);
  CALL(IMechSimRemote, stepOnce, run);
  await(run, ms::SIM_PAUSED);
  CALL(IMechSimRemote, runTo, run, 0.5);
  await(run, ms::SIM_PAUSED);
  ms::OctetSeq_var saved = CALL(IMechSimRemote, checkpoint, run);
  CALL(IMechSimRemote, resume, run);
  CALL(IMechSimRemote, pause, run);
  CORBA::Double time = 0;
  ms::DoubleSeq_var state = CALL(IMechSimRemote, getStates, run, time);
  require(state->length() == states->length(), "a number for each state");
  CALL(IMechSimRemote, cancel, run);
  await(run, ms::SIM_CANCELLED);
  ms::IMechSimRemote_var again =
      session->createSimulation(options({{"t-end", "1e6"}, {"t-step", "1e3"}}), ms::IMechClient::_nil());
  CALL(IMechSimRemote, restore, again, saved);
  again->destroy();
}

void runToTheEnd(ms::MechSim_ptr session, ms::IMechClient_ptr callback) {
  ms::RunSetUp_var setUp = CALL(MechSim, prepareSimulation, session, ms::NameValueSeq(), callback);
  CALL(IMechSimRemote, start, setUp->simulation);
  readRows(setUp->simulation);
  ms::Progress_var progress = CALL(IMechSimRemote, getProgress, setUp->simulation);
  require(progress->state == ms::SIM_DONE && progress->rowsReady == 301, "done with 301 rows");
  CORBA::String_var report = CALL(IMechSimRemote, report, setUp->simulation);
  require(std::string(report).find("\"outcome\"") != std::string::npos, "a report");
}

// A model that fails in its first step: velocities whose squares are beyond the range of numbers.
void fail(ms::MechSim_ptr session, ms::ModelFile model) {
  std::string text(reinterpret_cast<const char*>(model.content.get_buffer()), model.content.length());
  text.replace(text.find("-9.81"), 5, "-1e300");
  model.content.length(text.size());
  std::copy(text.begin(), text.end(), model.content.get_buffer());
  ms::DiagnosticSeq_var said = session->loadModel(model, ms::ModelFileSeq());
  ms::IMechSimRemote_var run = session->createSimulation(ms::NameValueSeq(), ms::IMechClient::_nil());
  run->start();
  await(run, ms::SIM_FAILED);
  ms::FailureRecord_var failure = CALL(IMechSimRemote, failure, run);
  require(std::string(failure->code).substr(0, 2) == "N-", "a code of the catalogue");
}

// How many connections this process has opened.
std::atomic<int> opened{0};

CORBA::Boolean countConnection(omni::omniInterceptors::clientOpenConnection_T::info_T&) {
  ++opened;
  return true;
}

template <typename Call>
void requireTooLarge(const char* operation, Call call) {
  try {
    call();
  } catch (const ms::LimitExceeded& e) {
    require(std::string(e.code) == "S-105", "the code of a request that is too large");
    std::cout << operation << " is refused: " << e.code << " " << e.text << std::endl;
    return;
  }
  throw std::runtime_error(std::string(operation) + " takes 50 MB");
}

// Models of 50 MB are refused as such, and the connections over which they came go on.
void sendLargeModels(ms::MechServer_ptr server, ms::MechSim_ptr session) {
  ms::ModelFile large;
  large.fileName = "large.xml";
  large.content.length(50u << 20);
  std::fill_n(large.content.get_buffer(), large.content.length(), CORBA::Octet(' '));
  int before = opened;
  require(before > 0, "connections are counted");
  requireTooLarge("importModel", [&] {
    ms::DiagnosticSeq_var losses;
    ms::ModelFile_var imported = server->importModel(large, losses.out());
  });
  requireTooLarge("loadModel", [&] {
    ms::DiagnosticSeq_var warnings = session->loadModel(large, ms::ModelFileSeq());
  });
  ms::ServerInfo_var info = server->getInfo();
  CORBA::String_var id = session->sessionId();
  require(opened == before, "the connections go on");
}

void askOfModel(ms::MechSim_ptr session) {
  ms::ModelInfo_var info = CALL(MechSim, getModelInfo, session);
  require(std::string(info->sha256).size() == 64, "the model's SHA-256");
  ms::ParameterSeq_var parameters = CALL(MechSim, parameters, session);
  ms::RoadmapEntrySeq_var roadmap = CALL(MechSim, roadmap, session);
  require(roadmap->length() > 0, "a roadmap");
  CORBA::String_var check = CALL(MechSim, checkReport, session, true);
  ms::ModelFile_var source = CALL(MechSim, generatedSource, session, ms::NameValueSeq());
  require(source->content.length() > 0, "a source");
}

void fetchJars(ms::MechSim_ptr session) {
  ms::JarInfo_var info;
  ms::OctetSeq_var jar = CALL(MechSim, compileToJar, session, ms::NameValueSeq(), info.out());
  require(jar->length() == info->sizeBytes, "the JAR is as long as announced");
  ms::JarInfo_var same;
  ms::OctetSeq_var again = CALL(MechSim, compileToJar, session, ms::NameValueSeq(), same.out());
  require(std::string(info->sha256) == same->sha256.in(), "the same JAR twice");
  // For a run at once: packed in less time, unpacked to the same classes.
  ms::NameValueSeq_var facts;
  ms::JarInfo_var prepared;
  ms::OctetSeq_var quick =
      CALL(MechSim, prepareJar, session, ms::NameValueSeq(), prepared.out(), facts.out());
  require(quick->length() == prepared->sizeBytes, "the prepared JAR is as long as announced");
  require(prepared->modelBytes >= info->modelBytes, "packed less tightly");
  ms::ModelReading_var reading = CALL(MechSim, readWith, session, ms::NameValueSeq());
  require(reading->simulations.length() == 1, "the simulation of the file is named");
  CORBA::String_var checked = CALL(MechSim, checkReportWith, session, ms::NameValueSeq(), false);
  require(std::string(checked).find("Degrees of freedom") != std::string::npos, "a check report");
  ms::RuntimeInfo_var runtime = CALL(MechSim, getRuntimeInfo, session);
  ms::OctetSeq_var solver = CALL(MechSim, fetchRuntime, session, runtime->sha256);
  require(solver->length() == runtime->sizeBytes, "the runtime is as long as announced");
}

void useServer(ms::MechServer_ptr server, const ms::ModelFile& model, const ms::ModelFile& robot,
               ms::IMechClient_ptr callback) {
  ms::ServerInfo_var info = CALL(MechServer, getInfo, server);
  require(std::string(info->apiVersion) == ms::API_VERSION, "the same contract");
  ms::LimitSeq_var limits = CALL(MechServer, limits, server);
  ms::DiagnosticSeq_var losses;
  ms::ModelFile_var imported = CALL(MechServer, importModel, server, robot, losses.out());
  ms::MechSim_var session = CALL(MechServer, createSession, server, "cpp", "", callback);
  CORBA::String_var id = CALL(MechSim, sessionId, session);
  CORBA::String_var host = CALL(MechSim, hostName, session);
  ms::MechSim_var same = CALL(MechServer, findSession, server, id);
  sendLargeModels(server, session);
  ms::DiagnosticSeq_var warnings = CALL(MechSim, loadModel, session, model, ms::ModelFileSeq());
  askOfModel(session);
  runToTheEnd(session, callback);
  steer(session);
  fetchJars(session);
  ms::NameValueSeq_var times = CALL(MechSim, timings, session);
  ms::SimEventSeq_var events = CALL(MechSim, pollEvents, session, 0, 10, 0);
  require(events->length() > 0, "events");
  fail(session, model);
  session->destroy();
}

// A simulation that goes on until somebody ends it.
ms::IMechSimRemote_ptr endless(ms::MechSim_ptr session, const ms::ModelFile& model,
                               ms::IMechClient_ptr callback) {
  ms::DiagnosticSeq_var said = session->loadModel(model, ms::ModelFileSeq());
  ms::IMechSimRemote_var run =
      session->createSimulation(options({{"t-end", "1e9"}, {"t-step", "1e5"}}), callback);
  run->start();
  await(run, ms::SIM_RUNNING);
  return run._retn();
}

void administrate(ms::MechServer_ptr server, ms::MechAdmin_ptr admin, const ms::ModelFile& model,
                  Watcher& watcher, ms::IMechClient_ptr callback) {
  ms::ServerStatus_var status = CALL(MechAdmin, getStatus, admin);
  ms::HostStatusSeq_var hosts = CALL(MechAdmin, listHosts, admin);
  ms::MechSim_var session = server->createSession("cpp", "", callback);
  CORBA::String_var host = session->hostName();
  ms::IMechSimRemote_var run = endless(session, model, callback);
  CORBA::String_var id = run->simId();
  ms::IMechSimRemote_var same = CALL(MechServer, findSimulation, server, id);
  require(watcher.await(3), "status, messages and progress come while it runs");
  CORBA::ULong total = 0;
  ms::SimSummarySeq_var all = CALL(MechAdmin, listSimulations, admin, 0, 100, total);
  require(total > 0, "simulations");
  ms::SimDetail_var detail = CALL(MechAdmin, showSimulation, admin, id);
  CALL(MechAdmin, killSimulation, admin, id, "enough");
  await(run, ms::SIM_CANCELLED);
  ms::ServiceEventSeq_var events = CALL(MechAdmin, events, admin, 0, 10, 0);
  require(events->length() > 0, "events");
  ms::LogLineSeq_var logs = CALL(MechAdmin, logs, admin, "", 0, 10);
  ms::LimitSeq_var limits = CALL(MechAdmin, getLimits, admin, "");
  CALL(MechAdmin, setLimits, admin, "", limits);
  CORBA::String_var placement = CALL(MechAdmin, getPlacement, admin);
  CALL(MechAdmin, setPlacement, admin, placement);
  CALL(MechAdmin, drain, admin, host);
  CALL(MechAdmin, undrain, admin, host);
  CORBA::String_var sessionId = session->sessionId();
  ms::SessionSummarySeq_var sessions = CALL(MechAdmin, listSessions, admin);
  require(sessions->length() > 0, "sessions");
  require(CALL(MechAdmin, endSessions, admin, "", sessionId, "enough") == 1, "one session ends");
}

void useHost(ms::MechSimHost_ptr host, const ms::ModelFile& model) {
  ms::HostInfo_var info = CALL(MechSimHost, getInfo, host);
  ms::HostLoad_var load = CALL(MechSimHost, getLoad, host);
  ms::MechSim_var session = CALL(MechSimHost, createSession, host, "cpp", ms::IMechClient::_nil());
  CORBA::String_var sessionId = session->sessionId();
  ms::MechSim_var same = CALL(MechSimHost, findSession, host, sessionId, "");
  ms::IMechSimRemote_var run = endless(session, model, ms::IMechClient::_nil());
  CORBA::String_var id = run->simId();
  ms::IMechSimRemote_var found = CALL(MechSimHost, findSimulation, host, id, "");
  ms::SimSummarySeq_var all = CALL(MechSimHost, listSimulations, host);
  require(all->length() > 0, "simulations");
  ms::SimDetail_var detail = CALL(MechSimHost, showSimulation, host, id);
  ms::SimDetail_var record = CALL(MechSimHost, recordOf, host, id);
  require(*record->checkReportJson == 0, "no check report");
  CALL(MechSimHost, killSimulation, host, id, "enough");
  ms::ServiceEventSeq_var events = CALL(MechSimHost, events, host, 0, 10, 0);
  ms::LogLineSeq_var logs = CALL(MechSimHost, logs, host, 0, 10);
  ms::LimitSeq_var limits = CALL(MechSimHost, getLimits, host);
  CALL(MechSimHost, setLimits, host, limits);
  CALL(MechSimHost, drain, host);
  CALL(MechSimHost, undrain, host);
  ms::SessionSummarySeq_var sessions = CALL(MechSimHost, listSessions, host);
  require(sessions->length() > 0, "sessions");
  require(CALL(MechSimHost, endSessions, host, "", sessionId, "enough") == 1, "one session ends");
}

template <class Interface>
typename Interface::_var_type published(CORBA::ORB_ptr orb, std::string url, const char* key) {
  url.replace(url.rfind('/') + 1, std::string::npos, key);
  CORBA::Object_var object = orb->string_to_object(url.c_str());
  typename Interface::_var_type found = Interface::_narrow(object);
  require(!CORBA::is_nil(found), key);
  return found;
}

void everyOperation(CORBA::ORB_ptr orb, char** argv, Registry& registry, Server& self) {
  ms::ModelFile model = readModel(argv[2]);
  ms::ModelFile robot = readModel(argv[3]);
  CORBA::Object_var object = orb->resolve_initial_references("omniINSPOA");
  PortableServer::POA_var named = PortableServer::POA::_narrow(object);
  PortableServer::POAManager_var manager = named->the_POAManager();
  PortableServer::ObjectId_var registryId = PortableServer::string_to_ObjectId("HostRegistry");
  PortableServer::ObjectId_var serverId = PortableServer::string_to_ObjectId("MechServer");
  named->activate_object_with_id(registryId, &registry);
  named->activate_object_with_id(serverId, &self);
  manager->activate();
  PortableServer::POA_var poa = callbackPoa(orb);
  PortableServer::Servant_var<Watcher> watcher = new Watcher;
  PortableServer::ObjectId_var id = poa->activate_object(watcher.in());
  ms::IMechClient_var callback = watcher->_this();
  std::cout << "ready" << std::endl;

  std::string url;
  require(static_cast<bool>(std::getline(std::cin, url)), "no URL on standard input");
  ms::HostInfo info;
  ms::MechSimHost_var host = registry.awaitHost(info);
  auto server = published<ms::MechServer>(orb, url, "MechServer");
  auto admin = published<ms::MechAdmin>(orb, url, "MechAdmin");
  auto hosts = published<ms::HostRegistry>(orb, url, "HostRegistry");
  useServer(server, model, robot, callback);
  administrate(server, admin, model, *watcher.in(), callback);
  CALL(IMechClient, heartbeat, callback);
  require(watcher->await(4), "every callback comes");
  useHost(host, model);
  ms::HostRegistration_var registration = CALL(HostRegistry, registerHost, hosts, info, host);
  registration->renewLease();
  registration->destroy();
  CALL(MechSimHost, shutdownHost, host, 0);
  CALL(MechAdmin, shutdownServer, admin, 0);
}

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: every-operation PORT MODEL.xml ROBOT.urdf\n";
    return 2;
  }
  Registry registry;  // these live longer than the ORB that calls them
  Server self;
  try {
    std::string endPoint = std::string("giop:tcp:127.0.0.1:") + argv[1];
    CORBA::ORB_var orb = startOrb(argc, argv, endPoint);
    omni::omniInterceptors* interceptors = omniORB::getInterceptors();
    interceptors->clientOpenConnection.add(countConnection);
    everyOperation(orb, argv, registry, self);
    orb->destroy();
    return 0;
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
  } catch (const ms::LimitExceeded& e) {
    std::cerr << e.code << " " << e.text << '\n';
  } catch (const ms::InvalidOption& e) {
    std::cerr << e.code << " " << e.text << '\n';
  } catch (const ms::InvalidState& e) {
    std::cerr << e.code << " " << e.text << '\n';
  } catch (const ms::NotAvailable& e) {
    std::cerr << e.code << " " << e.text << '\n';
  } catch (const CORBA::Exception& e) {
    std::cerr << e._name() << '\n';
  }
  return 1;
}
