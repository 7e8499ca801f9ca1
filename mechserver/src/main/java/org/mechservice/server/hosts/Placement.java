package org.mechservice.server.hosts;

import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerFailure;
import org.mechservice.sim.service.contract.ContractErrors;
import org.omg.CORBA.UserException;

/** Chooses the host of a session by the last known load, and calls only the chosen host. */
public final class Placement {
  private static final Comparator<RegisteredHost> MOST_FREE_FIRST =
      Comparator.comparingInt(RegisteredHost::freePlaces)
          .reversed()
          .thenComparing(RegisteredHost::own)
          .thenComparing(RegisteredHost::name);
  private static final Comparator<RegisteredHost> FIRST_WITH_A_PLACE =
      Comparator.comparing((RegisteredHost host) -> host.freePlaces() <= 0)
          .thenComparingLong(RegisteredHost::joined);

  /** Clients whose last host is remembered. */
  private static final int PINNED = 10_000;

  private final HostDirectory directory;
  private final Map<String, String> lastHostOf = Collections.synchronizedMap(new LatestClients());
  private volatile PlacementPolicy policy;

  private static final class LatestClients extends LinkedHashMap<String, String> {
    private static final long serialVersionUID = 1L;

    @Override
    protected boolean removeEldestEntry(Map.Entry<String, String> eldest) {
      return size() > PINNED;
    }
  }

  public Placement(HostDirectory directory, PlacementPolicy policy) {
    this.directory = directory;
    this.policy = policy;
  }

  public PlacementPolicy policy() {
    return policy;
  }

  public void follow(PlacementPolicy other) {
    policy = other;
  }

  /**
   * Opens a session on the best host that takes it.
   *
   * @throws LimitExceeded if none does
   */
  MechSim anywhere(String clientName, @Nullable IMechClient client)
      throws LimitExceeded, ServerFailure {
    Optional<LimitExceeded> refusal = Optional.empty();
    for (RegisteredHost host : candidates(clientName)) {
      HostCalls.Answer<MechSim> answer = open(host, clientName, client);
      if (answer.value().isPresent()) {
        return answer.value().get();
      }
      refusal =
          answer.refusal().filter(LimitExceeded.class::isInstance).map(LimitExceeded.class::cast);
    }
    throw refusal.orElseGet(
        () -> ContractErrors.noPlace("no host takes sessions now; start one with mech simhost"));
  }

  /**
   * Opens a session as {@link #anywhere} does, and ends it.
   *
   * @return why no host takes it; empty if one did
   */
  Optional<String> tryOut(String clientName) {
    String trouble = "no host takes sessions";
    for (RegisteredHost host : candidates(clientName)) {
      HostCalls.Answer<Integer> answer =
          directory
              .calls()
              .query(
                  host.host(),
                  asked -> {
                    asked.createSession(clientName, null);
                    return asked.endSessions(clientName, "", "it was tried out");
                  });
      if (answer.value().isPresent()) {
        return Optional.empty();
      }
      trouble =
          "host "
              + host.name()
              + " takes no session: "
              + answer.refusal().map(Placement::text).orElse(answer.failure());
    }
    return Optional.of(trouble);
  }

  private static String text(UserException refusal) {
    return refusal instanceof LimitExceeded limit
        ? limit.code + " " + limit.text
        : String.valueOf(refusal.getMessage());
  }

  private List<RegisteredHost> candidates(String clientName) {
    Comparator<RegisteredHost> order =
        switch (policy) {
          case ORDER -> FIRST_WITH_A_PLACE;
          case LEAST_LOADED -> MOST_FREE_FIRST;
          case PINNED -> {
            String last = lastHostOf.getOrDefault(clientName, "");
            yield Comparator.comparing((RegisteredHost host) -> !host.name().equals(last))
                .thenComparing(MOST_FREE_FIRST);
          }
        };
    return directory.all().stream().filter(RegisteredHost::open).sorted(order).toList();
  }

  /**
   * Opens a session on a host of the caller's choice.
   *
   * @throws NotFound if there is no such host
   * @throws LimitExceeded if it takes no session
   */
  MechSim on(String hostName, String clientName, @Nullable IMechClient client)
      throws LimitExceeded, NotFound, ServerFailure {
    RegisteredHost host = directory.find(hostName).orElseThrow(() -> noSuchHost(hostName));
    HostCalls.Answer<MechSim> answer = open(host, clientName, client);
    if (answer.value().isPresent()) {
      return answer.value().get();
    }
    if (answer.refusal().isPresent()) {
      throwRefusal(answer.refusal().get());
    }
    throw ContractErrors.noPlace("host " + hostName + " does not answer: " + answer.failure());
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
    List<String> names = directory.all().stream().map(RegisteredHost::name).toList();
    return ContractErrors.notFound(
        "there is no host \""
            + hostName
            + "\"; "
            + (names.isEmpty() ? "none is registered" : "there are " + String.join(", ", names)));
  }

  private HostCalls.Answer<MechSim> open(
      RegisteredHost host, String clientName, @Nullable IMechClient client) {
    HostCalls.Answer<MechSim> answer =
        directory.calls().query(host.host(), asked -> asked.createSession(clientName, client));
    if (answer.value().isPresent()) {
      host.placed();
      lastHostOf.put(clientName, host.name());
    } else if (!answer.failure().isEmpty()) {
      directory.failed(host, answer.failure(), answer.connectionLost());
    }
    return answer;
  }
}
