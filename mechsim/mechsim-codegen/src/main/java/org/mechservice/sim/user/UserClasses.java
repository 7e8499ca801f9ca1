package org.mechservice.sim.user;

import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import javax.tools.ToolProvider;
import org.mechservice.guard.BytecodeVerifier;
import org.mechservice.guard.ForceRelay;
import org.mechservice.guard.UserClassLoader;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.text.Sha256;

/**
 * The user classes that a model's forces need, directly or indirectly: checked but not loaded.
 * Immutable.
 */
public final class UserClasses {
  /** The classes of a model without user forces. */
  public static final UserClasses NONE = new UserClasses(Collections.emptySortedMap());

  private final SortedMap<String, byte[]> classFiles;
  private final Optional<ForceRelay> relay;

  private UserClasses(SortedMap<String, byte[]> classFiles) {
    this(Collections.unmodifiableSortedMap(classFiles), Optional.empty());
  }

  private UserClasses(SortedMap<String, byte[]> classFiles, Optional<ForceRelay> relay) {
    this.classFiles = classFiles;
    this.relay = relay;
  }

  /**
   * Admits the files that came with a model. Sources are compiled without annotation processors,
   * against Java and the force interface only. No class is loaded.
   *
   * @param mechanism mechanism with the forces
   * @param files files that came with the model; those that no force needs are ignored
   * @param compile whether sources may be compiled here
   * @throws MechmlException if a class is missing (S-121), a source may not (S-120) or cannot
   *     (S-123) be compiled, a class file cannot be used (S-124), a class is no force (S-068)
   */
  public static UserClasses admit(Mechanism mechanism, List<UserFile> files, boolean compile)
      throws MechmlException {
    List<UserForceElement> forces =
        mechanism.forces().stream()
            .filter(UserForceElement.class::isInstance)
            .map(UserForceElement.class::cast)
            .toList();
    if (forces.isEmpty()) {
      return NONE;
    }
    UserCodeFindings findings = new UserCodeFindings();
    SortedMap<String, byte[]> given = UserClassFiles.of(files, compile, findings);
    findings.throwIfAny();
    SortedMap<String, byte[]> needed = new NeededClasses(given, findings).of(forces);
    findings.throwIfAny();
    return new UserClasses(needed);
  }

  /**
   * Verifies that the classes may run on a server.
   *
   * @throws MechmlException S-156 if a class uses something not permitted; the message names method
   *     and line
   */
  public void requireHarmless() throws MechmlException {
    requireHarmless(classFiles);
  }

  /**
   * Verifies that classes may run on a server.
   *
   * @param classFiles bytes by binary class name; not modified
   * @throws MechmlException S-156 if a class uses something not permitted
   */
  public static void requireHarmless(SortedMap<String, byte[]> classFiles) throws MechmlException {
    UserCodeFindings findings = new UserCodeFindings();
    BytecodeVerifier.check(classFiles)
        .forEach(
            use ->
                findings.add(
                    MessageCode.USER_CLASS_NOT_PERMITTED,
                    use.className(),
                    use.line(),
                    0,
                    use.text()));
    findings.throwIfAny();
  }

  /** Starts a compiler ahead of the first source; without a compiler in this Java, does nothing. */
  public static void prepareCompiler() {
    if (ToolProvider.getSystemJavaCompiler() != null) {
      CompilerProcess.prepare();
    }
  }

  /**
   * Returns these classes for models that run in this process: verified, and called in confined
   * processes.
   *
   * @param consent whether they may run where they cannot be confined
   * @throws MechmlException S-156 if a class uses something not permitted
   */
  public UserClasses forThisProcess(UserCode consent) throws MechmlException {
    if (isEmpty()) {
      return this;
    }
    requireHarmless();
    return new UserClasses(classFiles, Optional.of(new ForceRelay(classFiles, consent)));
  }

  /** Returns whether there are none. */
  public boolean isEmpty() {
    return classFiles.isEmpty();
  }

  /** Returns class file bytes by binary class name; must not be modified. */
  public SortedMap<String, byte[]> classFiles() {
    return classFiles;
  }

  /** Returns the SHA-256 of these classes; empty if there are none. */
  public String sha256() {
    StringBuilder all = new StringBuilder();
    classFiles.forEach((name, bytes) -> all.append(name).append(Sha256.of(bytes)));
    return all.isEmpty() ? "" : Sha256.of(all.toString().getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Returns a loader of class files, by binary name, which can refer to Java and the force
   * interface only. For confined processes and for classes that no user has written.
   */
  public static ClassLoader loaderOf(SortedMap<String, byte[]> classFiles) {
    return new UserClassLoader(classFiles);
  }

  /**
   * Returns a loader of classes for a model that runs in this process: of the same names, but what
   * they do is done in a confined process.
   *
   * @throws IllegalArgumentException S-168 if this machine cannot confine them, and there is no
   *     consent to that
   * @throws IllegalStateException if they are not {@link #forThisProcess}
   */
  public ClassLoader loader() {
    if (isEmpty()) {
      return loaderOf(classFiles);
    }
    return relay
        .orElseThrow(() -> new IllegalStateException("classes of users do not run in this process"))
        .newLoader();
  }
}
