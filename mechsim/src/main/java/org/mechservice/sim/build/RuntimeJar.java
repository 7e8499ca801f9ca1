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
import org.mechservice.solver.pack.PackedClasses;
import org.mechservice.solver.simulation.SolverVersion;

/**
 * The solver as a JAR: all that models of any kind may need, but of the integration methods only
 * those that its service offers by name, and nothing of the main class of standalone JARs. Its
 * classes are packed together, which takes a sixth of the room they take one by one.
 */
final class RuntimeJar {
  private static final String CLASS = ".class";
  private static final String SOLVER = "org/mechservice/solver/";

  /** What is in these folders comes along if something else needs it. */
  private static final List<String> ON_DEMAND =
      List.of(
          SOLVER + "integration/",
          SOLVER + "linear/",
          SOLVER + "analysis/",
          SOLVER + "standalone/");

  /** What unpacks is there already. */
  private static final String PACKER = SOLVER + "pack/";

  private static final SortedMap<String, byte[]> CLASSES = contents();
  private static final PackedJar PACKED = pack();

  private RuntimeJar() {}

  static PackedJar packed() {
    return PACKED;
  }

  /** Returns whether the JAR has a class, by its path. */
  static boolean has(String path) {
    return CLASSES.containsKey(path);
  }

  private static PackedJar pack() {
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Implementation-Title", "MechService solver");
    manifest.put("Implementation-Version", SolverVersion.CURRENT);
    manifest.put("Mech-Api-Version", Integer.toString(Model.API_VERSION));
    ReproducibleJar jar = new ReproducibleJar(manifest);
    jar.add(PackedClasses.ENTRY, PackedClasses.pack(CLASSES));
    SolverFiles.lean().forEach((path, bytes) -> addOther(jar, path, bytes));
    byte[] bytes = jar.bytes();
    return new PackedJar(
        "mechservice-runtime-" + SolverVersion.CURRENT + ".jar",
        bytes,
        Sha256.of(bytes),
        "",
        0,
        manifest);
  }

  private static void addOther(ReproducibleJar jar, String path, byte[] bytes) {
    if (!path.endsWith(CLASS)) {
      jar.add(path, bytes);
    }
  }

  private static SortedMap<String, byte[]> contents() {
    SortedMap<String, byte[]> contents = new TreeMap<>(SolverFiles.lean());
    contents
        .keySet()
        .removeIf(
            path ->
                !path.endsWith(CLASS)
                    || path.startsWith(PACKER)
                    || ON_DEMAND.stream().anyMatch(path::startsWith));
    contents.putAll(ReachableClasses.from(contents, SolverFiles.lean()));
    return contents;
  }
}
