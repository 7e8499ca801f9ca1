package org.mechservice.client.jar;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.guard.BytecodeVerifier;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Sha256;

/**
 * The JAR of a model, whose classes are verified and not loaded: they use what the code of a model
 * needs, and nothing else.
 *
 * @param files what it holds
 * @param mainClass a model, or a source of models
 * @param sha256 of the JAR
 * @param generated class files of the model itself, by binary name
 * @param ofUsers class files of its users, by binary name
 */
record VerifiedJar(
    FetchedJar files,
    String mainClass,
    String sha256,
    SortedMap<String, byte[]> generated,
    SortedMap<String, byte[]> ofUsers) {
  private static final String CLASS = ".class";

  /** Package of generated classes; users have no classes there. */
  private static final String GENERATED = "org/mechservice/";

  /** Most that all classes of a model may have when they are inflated. */
  private static final long MOST_BYTES = 1L << 28;

  private static final String SHOWN_ATTRIBUTE = "Mech-Columns-Shown";
  private static final String REASON_ATTRIBUTE = "Mech-Formulation-Reason";

  /**
   * Verifies a model.
   *
   * @throws JarRefusedException if it is no JAR of a model of this version, or a class uses what it
   *     must not (S-232; of a user: S-156)
   */
  static VerifiedJar of(BuiltJar modelJar) {
    FetchedJar files = FetchedJar.read(modelJar.bytes(), "the model JAR");
    SortedMap<String, byte[]> generated = new TreeMap<>();
    SortedMap<String, byte[]> ofUsers = new TreeMap<>();
    long bytes = 0;
    for (String name : files.names()) {
      if (name.endsWith(CLASS)) {
        byte[] file = files.entry(name).orElseThrow();
        bytes += file.length;
        if (bytes > MOST_BYTES) {
          throw refused("has classes of more than " + MOST_BYTES + " bytes");
        }
        (name.startsWith(GENERATED) ? generated : ofUsers)
            .put(name.substring(0, name.length() - CLASS.length()).replace('/', '.'), file);
      }
    }
    requirePermitted(
        MessageCode.MODEL_CLASS_NOT_PERMITTED,
        BytecodeVerifier.checkModel(generated, ofUsers.keySet()));
    requirePermitted(MessageCode.USER_CLASS_NOT_PERMITTED, BytecodeVerifier.check(ofUsers));
    return new VerifiedJar(
        files, modelJar.mainClass(), Sha256.of(modelJar.bytes()), generated, ofUsers);
  }

  private static void requirePermitted(MessageCode code, List<BytecodeVerifier.Refusal> refusals) {
    refusals.stream()
        .findFirst()
        .ifPresent(
            use -> {
              throw new JarRefusedException(code.code(), use.text());
            });
  }

  /** Returns why a model JAR is not used. */
  static JarRefusedException refused(String why) {
    return new JarRefusedException(MessageCode.JAR_REFUSED.code(), "the model JAR " + why);
  }

  /** Returns the column groups that its file selects. */
  Set<ColumnGroup> shown() {
    return ColumnGroup.of(files.attribute(SHOWN_ATTRIBUTE).orElse(ColumnGroup.JOINTS.label()));
  }

  /** Returns the reason for the model's formulation; empty if unknown. */
  Optional<String> formulationReason() {
    return files.attribute(REASON_ATTRIBUTE);
  }
}
