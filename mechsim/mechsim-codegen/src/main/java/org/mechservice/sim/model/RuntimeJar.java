package org.mechservice.sim.model;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarInputStream;
import org.mechservice.sim.jar.Packing;
import org.mechservice.sim.jar.ReachableClasses;
import org.mechservice.sim.jar.ReproducibleJar;
import org.mechservice.sim.jar.Sha256;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.pack.KeptClasses;
import org.mechservice.solver.pack.PackedClasses;
import org.mechservice.solver.simulation.SolverVersion;

/**
 * The solver as a JAR: all that models of any kind may need, but of the integration methods only
 * those that its service offers by name, and nothing of the main class of standalone JARs. Its
 * classes are packed together, which takes a sixth of the room they take one by one.
 *
 * @param jar the JAR
 * @param classes paths of the classes in it, such as {@code org/mechservice/solver/api/Model.class}
 */
record RuntimeJar(PackedJar jar, Set<String> classes) {
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

  RuntimeJar {
    classes = Set.copyOf(classes);
  }

  /** Taken from the build, or packed, once per process, when first needed. */
  private static final class Holder {
    private static final RuntimeJar CURRENT = BuiltRuntime.find().orElseGet(RuntimeJar::pack);
  }

  static RuntimeJar current() {
    return Holder.CURRENT;
  }

  /** Returns whether the JAR has a class, by its path. */
  boolean has(String path) {
    return classes.contains(path);
  }

  /** Packs the solver of this process. */
  static RuntimeJar pack() {
    SortedMap<String, byte[]> classes = contents();
    byte[] packed = PackedClasses.pack(classes);
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Implementation-Title", "MechService solver");
    manifest.put("Implementation-Version", SolverVersion.CURRENT);
    manifest.put("Mech-Api-Version", Integer.toString(Model.API_VERSION));
    manifest.put(PackedClasses.KEPT_SHA_256, Sha256.of(kept(packed)));
    ReproducibleJar jar = new ReproducibleJar(manifest, Packing.QUICK);
    jar.add(PackedClasses.ENTRY, packed);
    SolverFiles.lean().forEach((path, bytes) -> addOther(jar, path, bytes));
    return new RuntimeJar(asJar(jar.bytes(), manifest), classes.keySet());
  }

  /**
   * Returns a JAR packed before.
   *
   * @throws IOException if it is no JAR
   */
  static RuntimeJar of(byte[] jar, Set<String> classes) throws IOException {
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(jar))) {
      Map<String, String> manifest = new LinkedHashMap<>();
      in.getManifest()
          .getMainAttributes()
          .forEach((name, value) -> manifest.put(name.toString(), value.toString()));
      manifest.remove(Attributes.Name.MANIFEST_VERSION.toString());
      return new RuntimeJar(asJar(jar, manifest), classes);
    }
  }

  private static PackedJar asJar(byte[] bytes, Map<String, String> manifest) {
    String name = "mechservice-runtime-" + SolverVersion.CURRENT + ".jar";
    return new PackedJar(name, bytes, Sha256.of(bytes), "", 0, manifest);
  }

  /** What clients will have unpacked; the constants of each class are in an order of their own. */
  private static byte[] kept(byte[] packed) {
    try {
      return KeptClasses.write(PackedClasses.unpack(packed));
    } catch (IOException e) {
      throw new UncheckedIOException("what was just packed is whole", e);
    }
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
    contents.putAll(ReachableClasses.from(contents, SolverFiles::lean));
    return contents;
  }
}
