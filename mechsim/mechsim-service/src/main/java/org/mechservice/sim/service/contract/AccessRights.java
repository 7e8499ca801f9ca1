package org.mechservice.sim.service.contract;

import java.lang.reflect.Method;
import java.util.Optional;
import java.util.Set;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.tls.Caller;
import org.mechservice.orb.tls.Role;
import org.mechservice.solver.catalogue.MessageCode;

/** The role that each operation requires. A caller without it is refused and logged. */
public final class AccessRights implements GuardedServant.Gate {
  /** Everything about administration that changes nothing. */
  private static final Set<String> LOOKING =
      Set.of(
          "getStatus",
          "listHosts",
          "listSimulations",
          "showSimulation",
          "listSessions",
          "events",
          "logs",
          "getLimits",
          "getPlacement");

  /** Operations that clients call before they have a session. */
  private static final Set<String> ASKING = Set.of("getInfo", "limits");

  private final Set<String> lesser;
  private final Optional<Role> forLesser;
  private final Role otherwise;
  private final DenialLog denials;

  private AccessRights(
      Set<String> lesser, Optional<Role> forLesser, Role otherwise, DenialLog denials) {
    this.lesser = lesser;
    this.forLesser = forLesser;
    this.otherwise = otherwise;
    this.denials = denials;
  }

  /** Monitors look, administrators act. An operation that is not known here is an action. */
  public static AccessRights toAdministrate(DenialLog denials) {
    return new AccessRights(LOOKING, Optional.of(Role.MONITOR), Role.ADMIN, denials);
  }

  /** Clients open sessions and take up simulations; anybody may ask what server this is. */
  public static AccessRights toSimulate(DenialLog denials) {
    return new AccessRights(ASKING, Optional.empty(), Role.CLIENT, denials);
  }

  /** Only machines register as hosts, call hosts, and renew registrations. */
  public static AccessRights toServe(DenialLog denials) {
    return new AccessRights(Set.of(), Optional.empty(), Role.SERVER, denials);
  }

  @Override
  public void pass(Method operation) throws NotAuthorized {
    Optional<Role> needed =
        lesser.contains(operation.getName()) ? forLesser : Optional.of(otherwise);
    if (needed.isPresent()) {
      Caller.current().require(needed.get());
    }
  }

  @Override
  public void refused(Method operation, Object[] arguments, NotAuthorized refusal) {
    String name = operation.getName();
    if (otherwise == Role.SERVER && refusal.code.equals(MessageCode.NOT_THE_OWNER.code())) {
      return; // the server called for a user, and records the refusal with the user's name
    }
    if (lesser.contains(name)) {
      denials.ofQuestion(Caller.current(), name, refusal);
    } else {
      denials.ofAction(Caller.current(), name, arguments, refusal);
    }
  }
}
