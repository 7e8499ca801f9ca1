package org.mechservice.server.hosts;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostRegistration;
import org.mechservice.idl.HostRegistrationHelper;
import org.mechservice.idl.HostRegistrationOperations;
import org.mechservice.idl.HostRegistrationPOATie;
import org.mechservice.idl.HostRegistryOperations;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.MechSimHost;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.orb.ActiveObject;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.connection.Endpoint;
import org.mechservice.orb.tls.Caller;
import org.mechservice.sim.service.contract.AccessRights;
import org.mechservice.sim.service.contract.DenialLog;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/**
 * Registers hosts. A host is called back at the address it names before it is taken in; without TLS
 * only hosts of the server's own machine are accepted, because others are not identified.
 */
public final class HostRegistryServant implements HostRegistryOperations {
  /** Number of calls to a host that registers before it counts as silent. */
  private static final int FIRST_CALLS = 5;

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._-]{1,64}");

  private final ServiceOrb orb;
  private final HostDirectory directory;
  private final FarmLimits limits;
  private final DenialLog denials;

  public HostRegistryServant(
      ServiceOrb orb, HostDirectory directory, FarmLimits limits, DenialLog denials) {
    this.denials = denials;
    this.limits = limits;
    this.orb = orb;
    this.directory = directory;
  }

  @Override
  public HostRegistration registerHost(HostInfo info, MechSimHost host)
      throws InvalidOption, NotAuthorized {
    requireUsable(info);
    Endpoint endpoint = requirePlace(info, host);
    requireNameFree(info, endpoint);
    call(info, host, endpoint);
    RegisteredHost known = new RegisteredHost(info, host, false, endpoint);
    HostRegistration registration = registration(known);
    directory.add(known);
    limits.joined(known);
    return registration;
  }

  private static void requireUsable(HostInfo info) throws InvalidOption {
    if (!NAME.matcher(info.name).matches()) {
      throw refused(
          "name",
          "\""
              + info.name
              + "\" is no host name: use 1 to 64 letters, digits, points, hyphens, underscores");
    }
    if (info.capacity < 1) {
      throw refused("capacity", "capacity is " + info.capacity + "; it must be 1 or more");
    }
  }

  private Endpoint requirePlace(HostInfo info, MechSimHost host)
      throws InvalidOption, NotAuthorized {
    Endpoint endpoint = endpointOf(host);
    if (!endpoint.toString().equals(info.address)) {
      throw refused(
          "address", "the host says it is at " + info.address + ", its object is at " + endpoint);
    }
    if (Caller.current().certificate().isEmpty() && !isLoopback(endpoint.host())) {
      throw new NotAuthorized(
          MessageCode.HOST_NOT_REGISTERED.code(),
          "host "
              + info.name
              + " is at "
              + endpoint
              + ", on another machine; without TLS a server takes hosts of its own machine only");
    }
    return endpoint;
  }

  private Endpoint endpointOf(MechSimHost host) throws InvalidOption {
    try {
      return orb.endpointOf(host);
    } catch (IllegalArgumentException e) {
      throw refused("address", "the host's reference names no address");
    }
  }

  private static boolean isLoopback(String host) {
    try {
      return InetAddress.getByName(host).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return false;
    }
  }

  private void requireNameFree(HostInfo info, Endpoint endpoint) throws InvalidOption {
    Optional<RegisteredHost> present = directory.find(info.name);
    if (present.isEmpty() || present.get().endpoint().equals(endpoint)) {
      return;
    }
    boolean alive =
        present.get().own()
            || directory
                .calls()
                .query(present.get().host(), MechSimHostOperations::getLoad)
                .value()
                .isPresent();
    if (alive) {
      throw refused(
          "name",
          "there is a host \""
              + info.name
              + "\" at "
              + present.get().endpoint()
              + " already; choose another name");
    }
  }

  private void call(HostInfo info, MechSimHost host, Endpoint endpoint) throws InvalidOption {
    try {
      orb.outbound().allow(endpoint.host(), endpoint.port());
    } catch (UnknownHostException e) {
      throw refused("address", "there is no host " + endpoint.host());
    }
    HostCalls.Answer<HostInfo> answer = answerOf(host);
    if (answer.value().isEmpty() || !answer.value().get().name.equals(info.name)) {
      orb.outbound().forbid(endpoint.host(), endpoint.port());
      throw refused("address", "the server cannot reach host " + info.name + " at " + endpoint);
    }
  }

  /** A process that has just started, on a machine under load, may answer its first call late. */
  private HostCalls.Answer<HostInfo> answerOf(MechSimHost host) {
    HostCalls.Answer<HostInfo> answer =
        directory.calls().query(host, MechSimHostOperations::getInfo);
    for (int i = 1; i < FIRST_CALLS && isLate(answer); i++) {
      answer = directory.calls().query(host, MechSimHostOperations::getInfo);
    }
    return answer;
  }

  private static boolean isLate(HostCalls.Answer<HostInfo> answer) {
    return answer.value().isEmpty() && answer.refusal().isEmpty() && !answer.connectionLost();
  }

  private static InvalidOption refused(String what, String text) {
    return new InvalidOption(MessageCode.HOST_NOT_REGISTERED.code(), text, what);
  }

  private HostRegistration registration(RegisteredHost host) {
    Registration registration = new Registration(host);
    ActiveObject object =
        orb.activate(
            new HostRegistrationPOATie(
                GuardedServant.of(
                    HostRegistrationOperations.class,
                    registration,
                    AccessRights.toServe(denials))));
    // A host that is killed never calls again; its registration must not stay for ever.
    host.onRemoval(object::close);
    return HostRegistrationHelper.unchecked_narrow(object.reference());
  }

  /** A host's standing; its renewal is the host's heartbeat. */
  private final class Registration implements HostRegistrationOperations {
    private final RegisteredHost host;

    Registration(RegisteredHost host) {
      this.host = host;
    }

    /** A host that was dropped, or replaced by another of its name, must register anew. */
    private void requirePresent() {
      if (directory.find(host.name()).filter(present -> present == host).isEmpty()) {
        throw new OBJECT_NOT_EXIST("not registered any more");
      }
      host.renew();
    }

    @Override
    public int renewLease() {
      requirePresent();
      return (int) Math.max(1, directory.tuning().hostLease().toSeconds());
    }

    @Override
    public void destroy() {
      requirePresent();
      directory.signOff(host);
    }
  }
}
