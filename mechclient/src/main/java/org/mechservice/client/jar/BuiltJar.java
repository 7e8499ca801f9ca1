package org.mechservice.client.jar;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.idl.JarInfo;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Sha256;

/**
 * A JAR made by the server, checked against the hash announced with it.
 *
 * @param fileName name the server suggests
 * @param bytes the file; not to be modified
 * @param sha256 hash of the file
 * @param mainClass class to start, or the model class of a JAR that needs the runtime JAR
 * @param modelClassBytes compressed size of the model's own classes
 * @param runtimeSha256 hash of the runtime JAR it needs; empty if it stands alone
 * @param signature detached signature by the server's key; empty: it has none
 * @param manifest formulation, integrator, what was left out and why
 */
@SuppressWarnings("ArrayRecordComponent") // a file's bytes, never changed
public record BuiltJar(
    String fileName,
    byte[] bytes,
    String sha256,
    String mainClass,
    long modelClassBytes,
    String runtimeSha256,
    byte[] signature,
    Map<String, String> manifest) {
  public BuiltJar {
    manifest = Collections.unmodifiableMap(new LinkedHashMap<>(manifest));
  }

  /**
   * Checks a received JAR against the announced hash.
   *
   * @throws JarRefusedException if they differ
   */
  static BuiltJar verified(byte[] bytes, JarInfo info) {
    return new BuiltJar(
        info.fileName,
        verified(bytes, info.sha256, "the model JAR"),
        info.sha256,
        info.mainClass,
        info.modelBytes,
        info.runtimeSha256,
        info.signature,
        RemoteCalls.textsOf(info.manifest));
  }

  /** Returns the names of the inputs that a program sets between two steps. */
  Set<String> inputs() {
    String names = manifest.getOrDefault("Mech-Inputs", "");
    return names.isEmpty() ? Set.of() : Set.of(names.split(" ", -1));
  }

  /**
   * Returns the bytes if they have the announced hash.
   *
   * @param what the JAR's name in messages
   * @throws JarRefusedException if they do not
   */
  static byte[] verified(byte[] bytes, String announced, String what) {
    String found = Sha256.of(bytes);
    if (!found.equals(announced)) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(),
          what
              + " was changed on its way: announced with SHA-256 "
              + announced
              + ", arrived with "
              + found);
    }
    return bytes;
  }
}
