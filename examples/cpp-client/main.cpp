// Runs a MechML model on a MechService server and writes the results as CSV.
//
//   mech-client URL MODEL.xml OUT.csv [OPTION=VALUE ...]
//
// URL is what `mech server` prints, corbaloc:iiop:1.2@HOST:PORT/MechServer; the options are those of
// the contract (mechservice.idl), such as rtol=1e-10. The way through the service: MechServer ->
// MechSim -> IMechSimRemote -> ResultCursor; the server's callbacks to our IMechClient come back
// over the connection we opened (bidirectional GIOP), so no port of this machine is reached from
// outside. Exit status: 0 done, 1 the simulation failed, 2 bad usage or model, 3 server or network.

#include "connection.hh"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

using Clock = std::chrono::steady_clock;

const CORBA::ULong ROWS_PER_BLOCK = 1000;

std::string described(const ms::Diagnostic& d) {
  std::string place = d.fileName.in();
  if (d.lineNo > 0) {
    place += ":" + std::to_string(d.lineNo) + ":" + std::to_string(d.columnNo);
  }
  return (place.empty() ? place : place + ": ") + d.code.in() + " " + d.text.in();
}

bool isEnd(ms::SimState state) {
  return state == ms::SIM_DONE || state == ms::SIM_FAILED || state == ms::SIM_CANCELLED;
}

// What the server tells us about our run. The ORB calls from a thread of its own.
class Watcher : public POA_mechservice::IMechClient {
 public:
  void onStatus(const char*, ms::SimState state, const char* text) override {
    std::lock_guard<std::mutex> lock(mutex_);
    ++statusCount_;
    std::cerr << "status: " << text << '\n';
    if (isEnd(state)) {
      ended_ = true;
      endSeen_.notify_all();
    }
  }

  void onProgress(const ms::Progress& progress) override {
    std::lock_guard<std::mutex> lock(mutex_);
    ++progressCount_;
    std::cerr << "progress: t = " << progress.simTime << " s of " << progress.endTime << " s\n";
  }

  void onMessages(const char*, const ms::DiagnosticSeq& messages) override {
    std::lock_guard<std::mutex> lock(mutex_);
    for (CORBA::ULong i = 0; i < messages.length(); ++i) {
      ++messageCount_;
      std::cerr << described(messages[i]) << '\n';
    }
  }

  void heartbeat() override {}

  // Callbacks are oneway: the last one may still be on its way when the results are complete.
  void awaitEnd(std::chrono::seconds patience) {
    std::unique_lock<std::mutex> lock(mutex_);
    endSeen_.wait_for(lock, patience, [this] { return ended_; });
  }

  void printCounts() {
    std::lock_guard<std::mutex> lock(mutex_);
    std::cout << "callbacks: status=" << statusCount_ << " progress=" << progressCount_
              << " messages=" << messageCount_ << '\n';
  }

 private:
  std::mutex mutex_;
  std::condition_variable endSeen_;
  bool ended_ = false;
  int statusCount_ = 0;
  int progressCount_ = 0;
  int messageCount_ = 0;
};

// Ends a lease at the end of a scope, however the scope is left.
class Held {
 public:
  explicit Held(ms::Leased_ptr leased) : leased_(ms::Leased::_duplicate(leased)) {}

  ~Held() {
    try {
      leased_->destroy();
    } catch (const CORBA::Exception&) {
      // The server is gone, or ends the lease by itself in a moment.
    }
  }

  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

 private:
  ms::Leased_var leased_;
};

ms::NameValueSeq readOptions(int argc, char** argv) {
  ms::NameValueSeq options;
  for (int i = 4; i < argc; ++i) {
    std::string text = argv[i];
    std::size_t sign = text.find('=');
    if (sign == std::string::npos) {
      throw std::invalid_argument(text + ": an option is written NAME=VALUE");
    }
    CORBA::ULong n = options.length();
    options.length(n + 1);
    options[n].key = text.substr(0, sign).c_str();
    options[n].text = text.substr(sign + 1).c_str();
  }
  return options;
}

void writeHeader(std::ofstream& out, const ms::ChannelSeq& channels) {
  for (CORBA::ULong i = 0; i < channels.length(); ++i) {
    out << (i == 0 ? "" : ",") << channels[i].name.in();
  }
  out << "\r\n";
}

void writeRows(std::ofstream& out, const ms::ResultBlock& block) {
  for (CORBA::ULong row = 0; row < block.rowCount; ++row) {
    for (CORBA::ULong column = 0; column < block.columnCount; ++column) {
      char number[32];  // 17 digits read back to the same double
      std::snprintf(number, sizeof number, "%.17g", block.values[row * block.columnCount + column]);
      out << (column == 0 ? "" : ",") << number;
    }
    out << "\r\n";
  }
}

// Pulls results until the run has ended and its last row is here; returns how many rows there were.
long pullResults(ms::MechSim_ptr session, ms::IMechSimRemote_ptr simulation, std::ofstream& out) {
  ms::ResultCursor_var cursor = simulation->openResults(ms::StringSeq());
  Held cursorLease(cursor);
  ms::ChannelSeq_var channels = cursor->channels();
  writeHeader(out, channels);
  long rows = 0;
  Clock::time_point renewed = Clock::now();
  for (bool ended = false; !ended;) {
    ms::ResultBlock_var block;
    cursor->nextBlock(ROWS_PER_BLOCK, ms::MAX_WAIT_MILLIS, block.out());
    writeRows(out, block);
    rows += block->rowCount;
    ended = block->endOfData;
    if (Clock::now() - renewed > std::chrono::seconds(10)) {  // well within the server's lease
      session->renewLease();
      simulation->renewLease();
      renewed = Clock::now();
    }
  }
  return rows;
}

int simulate(CORBA::ORB_ptr orb, int argc, char** argv) {
  ms::ModelFile model = readModel(argv[2]);
  ms::NameValueSeq options = readOptions(argc, argv);

  PortableServer::POA_var poa = callbackPoa(orb);
  PortableServer::Servant_var<Watcher> watcher = new Watcher;
  PortableServer::ObjectId_var id = poa->activate_object(watcher.in());
  ms::IMechClient_var callback = watcher->_this();

  CORBA::Object_var object = orb->string_to_object(argv[1]);
  ms::MechServer_var server = ms::MechServer::_narrow(object);
  if (CORBA::is_nil(server)) {
    std::cerr << argv[1] << ": not a MechServer\n";
    return 3;
  }
  ms::MechSim_var session = server->createSession("cpp-client", "", callback);
  Held sessionLease(session);
  session->loadModel(model, ms::ModelFileSeq());
  ms::IMechSimRemote_var simulation = session->createSimulation(options, callback);
  Held simulationLease(simulation);
  std::ofstream out(argv[3], std::ios::binary);
  if (!out) {
    throw std::invalid_argument(std::string(argv[3]) + ": cannot be written");
  }
  simulation->start();
  long rows = pullResults(session, simulation, out);
  out.close();
  watcher->awaitEnd(std::chrono::seconds(5));

  ms::Progress_var progress = simulation->getProgress();
  int status = 0;
  if (progress->state == ms::SIM_FAILED) {
    ms::FailureRecord_var failure = simulation->failure();
    std::cerr << failure->code << " " << failure->text << '\n';
    status = 1;
  }
  CORBA::String_var report = simulation->report();
  std::cout << report << '\n' << "rows: " << rows << '\n';
  watcher->printCounts();
  return status;
}

// Every exception of the contract carries a code and a text for people.
template <class Refusal>
int refused(const Refusal& e, int status) {
  std::cerr << e.code << " " << e.text << '\n';
  return status;
}

int main(int argc, char** argv) {
  try {
    CORBA::ORB_var orb = startOrb(argc, argv);
    if (argc < 4) {
      std::cerr << "usage: mech-client URL MODEL.xml OUT.csv [OPTION=VALUE ...]\n";
      return 2;
    }
    int status = simulate(orb, argc, argv);
    orb->destroy();
    return status;
  } catch (const std::invalid_argument& e) {
    std::cerr << e.what() << '\n';
    return 2;
  } catch (const ms::InvalidModel& e) {
    for (CORBA::ULong i = 0; i < e.diagnostics.length(); ++i) {
      std::cerr << described(e.diagnostics[i]) << '\n';
    }
    return 2;
  } catch (const ms::InvalidOption& e) {
    return refused(e, 2);
  } catch (const ms::LimitExceeded& e) {
    return refused(e, 3);
  } catch (const ms::ServerFailure& e) {
    return refused(e, 3);
  } catch (const CORBA::UserException& e) {
    std::cerr << argv[1] << ": the server refused: " << e._name() << '\n';
    return 3;
  } catch (const CORBA::SystemException& e) {
    std::cerr << argv[1] << ": no answer: " << e._name() << " " << e.NP_minorString() << '\n';
    return 3;
  }
}
