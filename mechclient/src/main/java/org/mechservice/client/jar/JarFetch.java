package org.mechservice.client.jar;

import java.util.Optional;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.SetUpCalls;
import org.mechservice.guard.SolverClasses;
import org.mechservice.idl.JarInfo;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.RuntimeInfo;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.SolverVersion;

/**
 * Fetches the JARs of a session's model, and accepts only JARs with the announced hash and, over
 * TLS, a valid signature. A solver is fetched only where it differs from this process's.
 *
 * @param calls to the session's host
 * @param setUp calls that set the model up
 * @param session the session
 * @param cache stores the solver of a server that has another one
 * @param accepted whose solvers may run here
 * @param serverVersion version of the server's solver, for messages
 * @param origin checks that a JAR comes from the host
 */
public record JarFetch(
    RemoteCalls calls,
    SetUpCalls setUp,
    MechSim session,
    JarCache cache,
    AcceptedSolvers accepted,
    String serverVersion,
    JarOrigin origin) {
  /** Entry of a model JAR's description: what identifies the solver that it was made for. */
  private static final String SOLVER = "Mech-Solver-Fingerprint";

  /** Read once per process, when first needed. */
  private static final class OwnSolver {
    private static final String FINGERPRINT = SolverClasses.fingerprint();
  }

  /**
   * Builds a JAR of the model at the host.
   *
   * @param options of the model and its solver; not modified
   * @param facts overwritten with what the server reports of the set-up
   * @throws InvalidOptionException if an option cannot be used
   * @throws JarRefusedException if what arrives is not what was announced
   */
  public BuiltJar model(NameValue[] options, NameValueSeqHolder facts) {
    JarInfoHolder holder = new JarInfoHolder();
    byte[] jar = setUp.get(patient -> patient.prepareJar(options, holder, facts));
    JarInfo info = holder.value;
    origin.verified(jar, info.signature, "the model JAR");
    return BuiltJar.verified(jar, info);
  }

  /**
   * Returns the solver that a model needs, from the cache if it is there; empty if it is that of
   * this process, to the last bit.
   *
   * @throws JarRefusedException if it is not the one the model names, or signed with no key that
   *     the user has accepted (S-231)
   */
  public Optional<byte[]> runtime(BuiltJar modelJar) {
    if (OwnSolver.FINGERPRINT.equals(modelJar.manifest().get(SOLVER))) {
      return Optional.empty();
    }
    if (!accepted.isAny()) {
      throw notAccepted("");
    }
    String sha256 = modelJar.runtimeSha256();
    byte[] runtimeJar = cache.get(sha256, () -> calls.get(() -> session.fetchRuntime(sha256)));
    RuntimeInfo runtime = calls.get(session::getRuntimeInfo);
    origin.verified(runtimeJar, runtime.signature, "the runtime JAR");
    if (!accepted.haveSigned(runtimeJar, runtime.signature)) {
      throw notAccepted(", and it is signed with no key that you have accepted");
    }
    return Optional.of(runtimeJar);
  }

  private JarRefusedException notAccepted(String why) {
    return new JarRefusedException(
        MessageCode.SOLVER_NOT_ACCEPTED.code(),
        "the server has another solver (version "
            + serverVersion
            + ") than this program (version "
            + SolverVersion.CURRENT
            + ")"
            + why
            + "; its classes would run here with all your rights: use the program of the server's"
            + " version, compute at the server without --mode local, or accept its key with"
            + " --trust-solver CERTIFICATE");
  }
}
