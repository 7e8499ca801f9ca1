package org.mechservice.cli.shell;

import org.mechservice.solver.simulation.SolverVersion;
import picocli.CommandLine.IVersionProvider;

/** The version that {@code mech --version} prints: that of the solver. */
public final class MechVersion implements IVersionProvider {
  @Override
  public String[] getVersion() {
    return new String[] {"mech " + SolverVersion.CURRENT};
  }
}
