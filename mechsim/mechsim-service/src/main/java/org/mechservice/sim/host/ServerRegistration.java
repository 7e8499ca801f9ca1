package org.mechservice.sim.host;

import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.HostRegistration;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSimHost;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.ServerFailure;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.SystemException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps a host registered at its server: renews at a third of the time granted, registers anew when
 * the server has forgotten the host or was restarted, signs off at the end.
 */
final class ServerRegistration implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(ServerRegistration.class);
  private static final long RETRY_MILLIS = 2000;
  private static final long CLOSING_MILLIS = 10_000;

  private final ServiceOrb orb;
  private final String serverUrl;
  private final SimHost host;
  private final MechSimHost reference;
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "mechservice-registration");
            thread.setDaemon(true);
            return thread;
          });
  private volatile @Nullable HostRegistration registration;

  ServerRegistration(ServiceOrb orb, String serverUrl, SimHost host, MechSimHost reference) {
    this.orb = orb;
    this.serverUrl = serverUrl;
    this.host = host;
    this.reference = reference;
  }

  /**
   * Registers the host.
   *
   * @throws ServiceUnreachableException if the server cannot be reached
   * @throws IllegalArgumentException if the server does not accept the host; the message names the
   *     reason
   */
  void begin() {
    registration = register();
    renew();
  }

  /** Registers the host as soon as the server can be reached. */
  void keepTrying() {
    LOG.info("server {} cannot be reached yet; trying again", serverUrl);
    renewIn(RETRY_MILLIS);
  }

  private HostRegistration register() {
    try {
      return orb.connectRegistry(serverUrl).registerHost(host.getInfo(), reference);
    } catch (InvalidOption e) {
      throw new IllegalArgumentException(e.code + " " + e.text, e);
    } catch (LimitExceeded e) {
      throw new IllegalArgumentException(e.code + " " + e.text, e);
    } catch (NotAuthorized e) {
      throw new IllegalArgumentException(e.code + " " + e.text, e);
    } catch (ServerFailure e) {
      throw new ServiceUnreachableException(e.code + " " + e.text, e);
    } catch (SystemException e) {
      throw new ServiceUnreachableException(
          MessageCode.NO_SERVER_ANSWERS
              + " the server at "
              + serverUrl
              + " was lost while the host was registered",
          e);
    }
  }

  private void renewIn(long millis) {
    try {
      var unused = clock.schedule(this::renew, millis, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      LOG.debug("the host is closing");
    }
  }

  private void renew() {
    HostRegistration present = registration;
    if (present == null) {
      registerAnew();
      return;
    }
    try {
      renewIn(Integer.toUnsignedLong(present.renewLease()) * 1000 / 3);
    } catch (SystemException e) {
      LOG.info("the server does not know this host any more; registering anew");
      registerAnew();
    }
  }

  private void registerAnew() {
    try {
      registration = register();
      LOG.info("registered again at {}", serverUrl);
      renewIn(RETRY_MILLIS);
    } catch (ServiceUnreachableException | IllegalArgumentException e) {
      LOG.info("not registered: {}", e.getMessage());
      renewIn(RETRY_MILLIS);
    }
  }

  /** Signs off. */
  @Override
  public void close() {
    clock.shutdownNow();
    try {
      clock.awaitTermination(CLOSING_MILLIS, TimeUnit.MILLISECONDS);
      HostRegistration present = registration;
      if (present != null) {
        present.destroy();
      }
    } catch (SystemException e) {
      LOG.debug("the server is gone already", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
