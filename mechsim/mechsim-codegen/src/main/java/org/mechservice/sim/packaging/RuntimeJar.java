package org.mechservice.sim.packaging;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarInputStream;
import java.util.jar.Manifest;
import org.mechservice.sim.compile.SolverClasses;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.simulation.SolverVersion;
import org.mechservice.solver.text.Sha256;

/**
 * The runtime JAR: every class of the solver, for models that travel without one. A client fetches
 * it once and keeps it by its SHA-256; on a class path, {@code RunModel} in it runs the model JAR
 * beside it.
 *
 * <p>The build makes it, because compressing the solver takes longer than a small simulation. Its
 * manifest holds a fingerprint of the class files it was made from. A process whose solver was
 * compiled since then has another fingerprint and makes the JAR anew.
 */
public final class RuntimeJar {
  private static final String RESOURCE = "runtime.jar";
  private static final String FINGERPRINT = "Mech-Solver-Fingerprint";

  private RuntimeJar() {}

  /** Read or made once per process, when first needed. */
  private static final class Holder {
    private static final JarImage CURRENT = ofBuild().orElseGet(RuntimeJar::make);
  }

  /** Returns the JAR of this process's solver. */
  public static JarImage current() {
    return Holder.CURRENT;
  }

  /** Returns the JAR that the build made, unless it is of another solver. */
  static Optional<JarImage> ofBuild() {
    try (InputStream file = RuntimeJar.class.getResourceAsStream(RESOURCE)) {
      if (file == null) {
        return Optional.empty();
      }
      byte[] bytes = file.readAllBytes();
      Map<String, String> manifest = manifestOf(bytes);
      return SolverClasses.fingerprint().equals(manifest.get(FINGERPRINT))
          ? Optional.of(image(bytes, manifest))
          : Optional.empty();
    } catch (IOException e) {
      throw new UncheckedIOException("the runtime JAR of the build cannot be read", e);
    }
  }

  private static Map<String, String> manifestOf(byte[] bytes) throws IOException {
    Map<String, String> attributes = new LinkedHashMap<>();
    try (JarInputStream jar = new JarInputStream(new ByteArrayInputStream(bytes))) {
      Manifest manifest = jar.getManifest();
      if (manifest != null) {
        manifest
            .getMainAttributes()
            .forEach((name, value) -> attributes.put(name.toString(), value.toString()));
      }
    }
    attributes.remove(Attributes.Name.MANIFEST_VERSION.toString());
    return attributes;
  }

  /** Makes the JAR from the class files of this process's solver. */
  static JarImage make() {
    Map<String, String> manifest = new LinkedHashMap<>();
    manifest.put("Implementation-Title", "MechService solver");
    manifest.put("Implementation-Version", SolverVersion.CURRENT);
    manifest.put("Mech-Api-Version", Integer.toString(Model.API_VERSION));
    manifest.put(FINGERPRINT, SolverClasses.fingerprint());
    ReproducibleJar jar = new ReproducibleJar(manifest);
    SolverClasses.files().forEach(jar::add);
    return image(jar.bytes(), manifest);
  }

  private static JarImage image(byte[] bytes, Map<String, String> manifest) {
    String name = "mechservice-runtime-" + SolverVersion.CURRENT + ".jar";
    return new JarImage(name, bytes, Sha256.of(bytes), "", 0, manifest);
  }

  /**
   * Writes the JAR beside this class, unless the one there is of this solver. The build calls it.
   *
   * @param arguments the folder of this module's classes
   * @throws IOException if it cannot be written
   */
  public static void main(String[] arguments) throws IOException {
    if (ofBuild().isEmpty()) {
      Path folder =
          Path.of(arguments[0]).resolve(RuntimeJar.class.getPackageName().replace('.', '/'));
      Files.createDirectories(folder);
      Files.write(folder.resolve(RESOURCE), make().bytes());
    }
  }
}
