package org.mechservice.sim.build;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.sim.build.jar.ReproducibleJar;
import org.mechservice.sim.build.jar.Sha256;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.simulation.SolverVersion;

/** The solver as a JAR. */
final class RuntimeJar {
  private static final PackedJar PACKED = pack();

  private RuntimeJar() {}

  static PackedJar packed() {
    return PACKED;
  }

  private static PackedJar pack() {
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Implementation-Title", "MechService solver");
    manifest.put("Implementation-Version", SolverVersion.CURRENT);
    manifest.put("Mech-Api-Version", Integer.toString(Model.API_VERSION));
    ReproducibleJar jar = new ReproducibleJar(manifest);
    SolverFiles.lean().forEach(jar::add);
    byte[] bytes = jar.bytes();
    return new PackedJar(
        "mechservice-runtime-" + SolverVersion.CURRENT + ".jar",
        bytes,
        Sha256.of(bytes),
        "",
        0,
        manifest);
  }
}
