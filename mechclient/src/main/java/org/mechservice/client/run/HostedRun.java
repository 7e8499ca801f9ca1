package org.mechservice.client.run;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;

/**
 * A run on its present host.
 *
 * @param calls to that host
 * @param hostName the host's name
 * @param session the run's session there
 * @param simulation the run
 * @param hold keeps it alive
 * @param rows cursor over its rows on that host
 * @param facts facts of its set-up, for the report
 * @param own a session that ends with the run; empty if the user ends the session
 */
public record HostedRun(
    RemoteCalls calls,
    String hostName,
    MechSim session,
    IMechSimRemote simulation,
    LeaseRenewal.Hold hold,
    RowCursor rows,
    Map<String, Object> facts,
    Optional<LeaseRenewal.Hold> own)
    implements AutoCloseable {

  /** Opens a run on another host. */
  public interface Opening {
    /**
     * Sets up the run on any host with a free place, in a session that ends with it.
     *
     * @param earlierIds its ids on other hosts, by which it can still be found
     * @throws ServiceException if no host takes it
     */
    HostedRun open(List<String> earlierIds);
  }

  /** Returns the same run with a session that ends with it. */
  public HostedRun endingWith(LeaseRenewal.Hold ended) {
    return new HostedRun(
        calls, hostName, session, simulation, hold, rows, facts, Optional.of(ended));
  }

  String id() {
    return calls.read(simulation::simId);
  }

  RunProgress progress() {
    return RunProgress.of(calls.read(simulation::getProgress));
  }

  void setParameters(Map<String, String> values) {
    NameValue[] all =
        values.entrySet().stream()
            .map(entry -> new NameValue(entry.getKey(), entry.getValue()))
            .toArray(NameValue[]::new);
    calls.run(() -> simulation.setParameters(all));
  }

  /** Returns a checkpoint of the present state of the run; empty if it is not between steps. */
  Optional<byte[]> checkpoint() {
    try {
      return Optional.of(calls.get(simulation::checkpoint));
    } catch (InvalidStateException e) {
      return Optional.empty();
    }
  }

  void restore(byte[] checkpoint) {
    calls.run(() -> simulation.restore(checkpoint));
  }

  /** Destroys the run on that host. */
  @Override
  public void close() {
    rows.close();
    hold.close();
    own.ifPresent(LeaseRenewal.Hold::close);
  }
}
