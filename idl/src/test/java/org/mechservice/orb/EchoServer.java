package org.mechservice.orb;

import java.util.Map;
import java.util.function.Consumer;
import org.mechservice.idl.API_VERSION;
import org.mechservice.idl.DiagnosticSeqHolder;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechClientPOATie;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.Limit;
import org.mechservice.idl.MechServerOperations;
import org.mechservice.idl.MechServerPOATie;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerInfo;
import org.omg.CORBA.NO_IMPLEMENT;
import org.omg.CORBA.SystemException;

/** A server that knows its name, and calls back whoever asks for a session. */
final class EchoServer implements MechServerOperations, AutoCloseable {
  private final ServiceOrb orb;
  private final String apiVersion;
  private volatile Consumer<IMechClient> callBack = IMechClient::heartbeat;

  private EchoServer(ServiceOrb orb, String apiVersion) {
    this.orb = orb;
    this.apiVersion = apiVersion;
  }

  static EchoServer start() {
    return start(API_VERSION.value);
  }

  static EchoServer start(String apiVersion) {
    EchoServer server =
        new EchoServer(ServiceOrb.server(new ListenAddress("127.0.0.1", 0)), apiVersion);
    server.orb.publish(Map.of(ServiceKey.SERVER, new MechServerPOATie(server)));
    return server;
  }

  /** Sets what is done with the callbacks of whoever asks for a session. */
  void onSession(Consumer<IMechClient> does) {
    callBack = does;
  }

  void allowConnections(int most) {
    orb.allowConnections(most);
  }

  int connections() {
    return orb.connections();
  }

  int busyConnections() {
    return orb.busyConnections();
  }

  String address() {
    return orb.endpoint().toString();
  }

  Runnable bind(String naming) {
    return orb.bind(naming, ServiceKey.SERVER);
  }

  String ior() {
    return orb.ior(ServiceKey.SERVER);
  }

  /** Returns the reference of an object that lives as long as it is called. */
  String object() {
    return orb.toIor(orb.activate(new IMechClientPOATie(new CountingClient())).reference());
  }

  int port() {
    return orb.endpoint().port();
  }

  @Override
  public ServerInfo getInfo() {
    return new ServerInfo("echo €", apiVersion, "0", 0, new String[0]);
  }

  @Override
  public MechSim createSession(String clientName, String hostName, IMechClient client)
      throws org.mechservice.idl.ServerFailure {
    try {
      callBack.accept(client);
    } catch (SystemException e) {
      throw new org.mechservice.idl.ServerFailure("S-001", e.toString(), "");
    }
    throw new org.mechservice.idl.ServerFailure("called back", clientName, "");
  }

  @Override
  public MechSim findSession(String sessionId) throws NotFound {
    throw new NotFound("S-011", sessionId);
  }

  @Override
  public IMechSimRemote findSimulation(String simId) throws NotFound {
    throw new NotFound("S-011", simId);
  }

  @Override
  public ModelFile importModel(ModelFile foreign, DiagnosticSeqHolder losses) {
    throw new NO_IMPLEMENT();
  }

  @Override
  public Limit[] limits() {
    return new Limit[0];
  }

  @Override
  public void close() {
    orb.close();
  }
}
