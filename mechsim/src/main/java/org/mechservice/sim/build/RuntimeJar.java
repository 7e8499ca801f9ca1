package org.mechservice.sim.build;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.sim.build.jar.ReachableClasses;
import org.mechservice.sim.build.jar.ReproducibleJar;
import org.mechservice.sim.build.jar.Sha256;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.integration.Integrator;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.simulation.SolverVersion;

/**
 * The solver as a JAR: all of it but the integration methods that its service does not offer by
 * name.
 */
final class RuntimeJar {
  private static final String SERVICE = path(RuntimeSolver.class);
  private static final List<String> METHOD_FOLDERS =
      List.of(folder(Integrator.class), "org/mechservice/solver/linear/");

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
    contents().forEach(jar::add);
    byte[] bytes = jar.bytes();
    return new PackedJar(
        "mechservice-runtime-" + SolverVersion.CURRENT + ".jar",
        bytes,
        Sha256.of(bytes),
        "",
        0,
        manifest);
  }

  private static SortedMap<String, byte[]> contents() {
    SortedMap<String, byte[]> contents = new TreeMap<>(SolverFiles.lean());
    SortedMap<String, byte[]> offered =
        ReachableClasses.from(
            new TreeMap<>(Map.of(SERVICE, SolverFiles.lean().get(SERVICE))), SolverFiles.lean());
    contents
        .keySet()
        .removeIf(
            path ->
                METHOD_FOLDERS.stream().anyMatch(path::startsWith) && !offered.containsKey(path));
    return contents;
  }

  private static String path(Class<?> type) {
    return type.getName().replace('.', '/') + ".class";
  }

  private static String folder(Class<?> type) {
    return type.getPackageName().replace('.', '/') + "/";
  }
}
