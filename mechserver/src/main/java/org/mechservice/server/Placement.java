package org.mechservice.server;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerFailure;
import org.mechservice.sim.service.Refusal;
import org.omg.CORBA.UserException;

/**
 * Chooses the host of a session: the one with most free places; among equals a registered host
 * before the server's own process, then by name.
 */
final class Placement {
  private static final Comparator<KnownHost> BEST_FIRST =
      Comparator.comparingInt(KnownHost::freePlaces)
          .reversed()
          .thenComparing(KnownHost::own)
          .thenComparing(KnownHost::name);

  private final HostDirectory directory;

  Placement(HostDirectory directory) {
    this.directory = directory;
  }

  /**
   * Opens a session on the best host that takes it.
   *
   * @throws LimitExceeded if none does
   */
  MechSim anywhere(String clientName, @Nullable IMechClient client)
      throws LimitExceeded, ServerFailure {
    List<KnownHost> candidates =
        directory.refresh().stream().filter(KnownHost::open).sorted(BEST_FIRST).toList();
    Optional<LimitExceeded> refusal = Optional.empty();
    for (KnownHost host : candidates) {
      HostCalls.Answer<MechSim> answer = open(host, clientName, client);
      if (answer.value().isPresent()) {
        return answer.value().get();
      }
      refusal =
          answer.refusal().filter(LimitExceeded.class::isInstance).map(LimitExceeded.class::cast);
    }
    throw refusal.orElseGet(
        () -> Refusal.noPlace("no host takes sessions now; start one with mech simhost"));
  }

  /**
   * Opens a session on a host of the caller's choice.
   *
   * @throws NotFound if there is no such host
   * @throws LimitExceeded if it takes no session
   */
  MechSim on(String hostName, String clientName, @Nullable IMechClient client)
      throws LimitExceeded, NotFound, ServerFailure {
    KnownHost host = directory.find(hostName).orElseThrow(() -> noSuchHost(hostName));
    HostCalls.Answer<MechSim> answer = open(host, clientName, client);
    if (answer.value().isPresent()) {
      return answer.value().get();
    }
    if (answer.refusal().isPresent()) {
      throwRefusal(answer.refusal().get());
    }
    throw Refusal.noPlace("host " + hostName + " does not answer: " + answer.failure());
  }

  private static void throwRefusal(UserException refusal) throws LimitExceeded, ServerFailure {
    if (refusal instanceof LimitExceeded e) {
      throw e;
    } else if (refusal instanceof ServerFailure e) {
      throw e;
    }
    throw new IllegalStateException(refusal);
  }

  private NotFound noSuchHost(String hostName) {
    List<String> names = directory.all().stream().map(KnownHost::name).toList();
    return Refusal.notFound(
        "there is no host \""
            + hostName
            + "\"; "
            + (names.isEmpty() ? "none is registered" : "there are " + String.join(", ", names)));
  }

  private HostCalls.Answer<MechSim> open(
      KnownHost host, String clientName, @Nullable IMechClient client) {
    HostCalls.Answer<MechSim> answer =
        directory.calls().ask(host.host(), asked -> asked.createSession(clientName, client));
    if (!answer.failure().isEmpty()) {
      directory.failed(host, answer.failure(), answer.connectionLost());
    }
    return answer;
  }
}
