package org.mechservice.sim.service.session;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.guard.SolverClasses;
import org.mechservice.idl.JarInfo;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.RuntimeInfo;
import org.mechservice.sim.packaging.JarImage;
import org.mechservice.sim.packaging.RuntimeJar;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.service.setup.SetUps;
import org.mechservice.solver.simulation.SolverVersion;

/**
 * Makes the JARs that leave a session: a model, with or without the solver, and the solver itself.
 * Each comes with its SHA-256 and, over TLS, with a signature by the server's key.
 */
final class SignedJars {
  /** Read once per process, when first needed. */
  private static final class OwnSolver {
    private static final String FINGERPRINT = SolverClasses.fingerprint();
  }

  private final Session session;

  SignedJars(Session session) {
    this.session = session;
  }

  /**
   * Returns the JAR of a model.
   *
   * @param info receives what the JAR is
   */
  byte[] ofModel(SetUps.Packed packed, JarInfoHolder info) {
    JarImage jar = packed.jar();
    info.value =
        new JarInfo(
            jar.fileName(),
            jar.mainClass(),
            jar.sha256(),
            jar.bytes().length,
            jar.modelBytes(),
            signature(jar),
            packed.runtime(),
            ContractTypes.nameValues(described(jar.manifest())));
    return jar.bytes();
  }

  /** Returns the description of a JAR with what identifies this process's solver. */
  private static Map<String, String> described(Map<String, String> manifest) {
    Map<String, String> all = new LinkedHashMap<>(manifest);
    all.put("Mech-Solver-Fingerprint", OwnSolver.FINGERPRINT);
    return all;
  }

  /** Returns what the JAR of the solver is, which runs the JARs of models. */
  RuntimeInfo runtime() {
    JarImage jar = RuntimeJar.current();
    return new RuntimeInfo(jar.sha256(), jar.bytes().length, signature(jar), SolverVersion.CURRENT);
  }

  /**
   * Returns the JAR of the solver.
   *
   * @throws NotFound if this server's is another one
   */
  static byte[] runtime(String sha256) throws NotFound {
    JarImage jar = RuntimeJar.current();
    if (!jar.sha256().equals(sha256)) {
      throw ContractErrors.notFound(
          "this server's runtime JAR is " + jar.sha256() + ", not " + sha256);
    }
    return jar.bytes();
  }

  /** Returns the detached signature of a JAR; empty without TLS, where the server has no key. */
  private byte[] signature(JarImage jar) {
    return session
        .host()
        .orb()
        .identity()
        .map(own -> own.sign(jar.bytes()))
        .orElseGet(() -> new byte[0]);
  }
}
