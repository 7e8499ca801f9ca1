package org.mechservice.cli.shell;

import java.security.PublicKey;
import java.util.List;
import java.util.Optional;
import org.mechservice.client.MechConnection;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.jar.JarCache;
import org.mechservice.guard.UserCode;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.session.WarmUp;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.solver.catalogue.MessageCode;

/** The service a command asks: one on the network, or one started for this command alone. */
public final class ServiceConnection implements AutoCloseable {
  /** Attempts to reach the server of this process, each of which takes seconds. */
  private static final int OWN_ATTEMPTS = 15;

  /** Name of the host within a command. */
  static final String EMBEDDED_NAME = "embedded";

  private final Optional<MechServerProcess> embedded;
  private final MechConnection connection;

  private ServiceConnection(Optional<MechServerProcess> embedded, MechConnection connection) {
    this.embedded = embedded;
    this.connection = connection;
  }

  /**
   * Connects to a service.
   *
   * @param asked the server; none: an embedded server on a free loopback port
   * @throws org.mechservice.client.failure.ServerLostException if no server answers there
   */
  public static ServiceConnection open(ServerOption asked) {
    return open(asked, UserCode.NONE);
  }

  /**
   * Connects to a service.
   *
   * @param asked the server; none: an embedded server on a free loopback port
   * @param userCode whether an embedded server runs classes of forces that it cannot confine
   * @throws org.mechservice.client.failure.ServerLostException if no server answers there
   */
  public static ServiceConnection open(ServerOption asked, UserCode userCode) {
    return open(asked, 1, userCode);
  }

  /**
   * Connects to a service.
   *
   * @param asked the server; none: an embedded server on a free loopback port
   * @param capacity simulations that an embedded server runs at once
   * @param userCode whether an embedded server runs classes of forces that it cannot confine
   * @throws org.mechservice.client.failure.ServerLostException if no server answers there
   */
  public static ServiceConnection open(ServerOption asked, int capacity, UserCode userCode) {
    if (!asked.address().isEmpty()) {
      List<PublicKey> accepted = asked.trustedSolvers();
      MechConnection connection =
          MechConnection.open(asked.address(), JarCache.ofUser(), asked.identity());
      accepted.forEach(connection::acceptSolversOf);
      return new ServiceConnection(Optional.empty(), connection);
    }
    WarmUp.beginToBuild();
    if (!userCode.isNone()) {
      UserClasses.prepareCompiler();
    }
    HostOptions embedded =
        new HostOptions(EMBEDDED_NAME, capacity, HostLimits.OWN, Optional.empty())
            .withUserCode(
                userCode.isUnconfined() ? UserCodePolicy.UNCONFINED : UserCodePolicy.CONFINED);
    MechServerProcess server =
        MechServerProcess.start(new ServerSettings("127.0.0.1", 0, embedded));
    try {
      return new ServiceConnection(Optional.of(server), connected(server));
    } catch (ServiceException e) {
      server.close();
      throw e;
    }
  }

  /** Connects to the server of this process, which is there, however long a busy machine takes. */
  private static MechConnection connected(MechServerProcess own) {
    for (int attempt = 1; ; attempt++) {
      try {
        return MechConnection.openOwn(own.url());
      } catch (ServerLostException e) {
        if (attempt == OWN_ATTEMPTS || !e.code().equals(MessageCode.NO_SERVER_ANSWERS.code())) {
          throw e;
        }
      }
    }
  }

  public MechConnection connection() {
    return connection;
  }

  @Override
  public void close() {
    connection.close();
    embedded.ifPresent(MechServerProcess::close);
  }
}
