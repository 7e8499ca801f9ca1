package org.mechservice.sim.packaging;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.guard.SolverClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.simulation.SolverVersion;
import org.mechservice.solver.text.Sha256;

/**
 * The runtime JAR: all classes of the solver, for model JARs without a solver. A client fetches it
 * once and caches it by its SHA-256; {@code RunModel} in it runs a model JAR on the same class
 * path.
 *
 * <p>The build makes it, because compressing the solver takes longer than a small simulation. A
 * record beside it has two lines: the fingerprint of the class files it was made from, and its
 * SHA-256. A process with a solver compiled later has another fingerprint and makes the JAR again.
 * A model JAR needs only the hash, so the JAR itself is read only when a client fetches it.
 */
public final class RuntimeJar {
  private static final String RESOURCE = "runtime.jar";
  private static final String RECORD = "runtime.txt";

  private RuntimeJar() {}

  /** Read or made once per process, when first needed. */
  private static final class Holder {
    private static final JarImage CURRENT = ofBuild().orElseGet(RuntimeJar::make);
  }

  /** Read or computed once per process, when first needed. */
  private static final class Hash {
    private static final String CURRENT = hashOfBuild().orElseGet(() -> current().sha256());
  }

  /** Returns the JAR of this process's solver. */
  public static JarImage current() {
    return Holder.CURRENT;
  }

  /** Returns the SHA-256 of {@link #current}; the JAR of the build is not read for it. */
  public static String sha256() {
    return Hash.CURRENT;
  }

  /** Returns the hash of the JAR that the build made, unless it contains another solver. */
  private static Optional<String> hashOfBuild() {
    return read(RECORD)
        .map(record -> new String(record, StandardCharsets.UTF_8).lines().toList())
        .filter(lines -> lines.size() == 2 && lines.get(0).equals(SolverClasses.fingerprint()))
        .map(lines -> lines.get(1));
  }

  /** Returns the JAR that the build made, unless it contains another solver. */
  static Optional<JarImage> ofBuild() {
    return hashOfBuild()
        .flatMap(
            hash -> read(RESOURCE).map(RuntimeJar::image).filter(jar -> jar.sha256().equals(hash)));
  }

  private static Optional<byte[]> read(String resource) {
    try (InputStream file = RuntimeJar.class.getResourceAsStream(resource)) {
      return file == null ? Optional.empty() : Optional.of(file.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException("the runtime JAR of the build cannot be read", e);
    }
  }

  /** Makes the JAR from the class files of this process's solver. */
  static JarImage make() {
    ReproducibleJar jar = new ReproducibleJar(manifest());
    SolverClasses.files().forEach(jar::add);
    return image(jar.bytes());
  }

  private static Map<String, String> manifest() {
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Implementation-Title", "MechService solver");
    manifest.put("Implementation-Version", SolverVersion.CURRENT);
    manifest.put("Mech-Api-Version", Integer.toString(Model.API_VERSION));
    return manifest;
  }

  private static JarImage image(byte[] bytes) {
    String name = "mechservice-runtime-" + SolverVersion.CURRENT + ".jar";
    return new JarImage(name, bytes, Sha256.of(bytes), "", 0, manifest());
  }

  /**
   * Writes the JAR and its record beside this class, unless they are up to date. The build calls
   * it.
   *
   * @param arguments the folder of this module's classes
   * @throws IOException if it cannot be written
   */
  public static void main(String[] arguments) throws IOException {
    if (ofBuild().isEmpty()) {
      Path folder =
          Path.of(arguments[0]).resolve(RuntimeJar.class.getPackageName().replace('.', '/'));
      Files.createDirectories(folder);
      JarImage made = make();
      Files.write(folder.resolve(RESOURCE), made.bytes());
      Files.write(folder.resolve(RECORD), List.of(SolverClasses.fingerprint(), made.sha256()));
    }
  }
}
