package org.mechservice.sim.service.contract;

import java.lang.reflect.Method;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.tls.Caller;

/**
 * Guards the objects of one session. Its owner and administrators may call them, and every such
 * call renews the session's lease. Calls of all others are refused and logged, although they hold a
 * reference.
 */
public final class OwnerGate implements GuardedServant.Gate {
  private final String owner;
  private final Runnable renewal;
  private final DenialLog denials;

  /**
   * @param owner the user who opened the session
   * @param renewal begins the session's lease anew
   */
  public OwnerGate(String owner, Runnable renewal, DenialLog denials) {
    this.owner = owner;
    this.renewal = renewal;
    this.denials = denials;
  }

  @Override
  public void pass(Method operation) throws NotAuthorized {
    Caller.current().requireOwner(owner);
    renewal.run();
  }

  @Override
  public void refused(Method operation, Object[] arguments, NotAuthorized refusal) {
    denials.ofAction(Caller.current(), operation.getName(), arguments, refusal);
  }
}
