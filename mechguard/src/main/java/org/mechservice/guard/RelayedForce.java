package org.mechservice.guard;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * A force whose class is in a confined process. Public because the classes that {@link ForceRelay}
 * writes extend it; of no use to others.
 */
public abstract class RelayedForce implements UserForce {
  private final RelayProcess.Handle handle;

  protected RelayedForce() {
    handle = ((ForceRelay.RelayLoader) getClass().getClassLoader()).create(this);
  }

  @Override
  public final void declare(ForceDeclaration model) {
    handle.declare(model);
  }

  @Override
  public final void apply(ForceState state, ForceLoads loads) {
    handle.apply(state, loads);
  }

  /** A force that has derivatives of its own. */
  public abstract static class WithDerivatives extends RelayedForce
      implements UserForce.Derivatives {
    protected WithDerivatives() {}

    @Override
    public final void differentiate(ForceState state, ForceBlocks blocks) {
      super.handle.differentiate(state, blocks);
    }
  }
}
