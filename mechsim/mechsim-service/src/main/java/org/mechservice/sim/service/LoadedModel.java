package org.mechservice.sim.service;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.sim.user.UserFile;

/**
 * A model file as a session holds it.
 *
 * @param fileName its name, for messages
 * @param content its bytes; not to be modified
 * @param options which of its simulations is meant, and what its parameters are set to
 * @param sha256 SHA-256 of its bytes, lower-case hexadecimal
 * @param text its bytes as UTF-8, for people to look at
 * @param model what it says
 * @param userClasses the classes that its forces name
 */
@SuppressWarnings("ArrayRecordComponent") // never compared; bytes as they came
record LoadedModel(
    String fileName,
    byte[] content,
    ReadOptions options,
    String sha256,
    String text,
    MechmlModel model,
    UserClasses userClasses) {

  /**
   * Reads a model file and the classes that come with it.
   *
   * @param compile whether sources of users may be compiled here
   * @throws MechmlException if it or one of the classes cannot be used
   */
  static LoadedModel read(
      String fileName, byte[] content, List<UserFile> userFiles, boolean compile)
      throws MechmlException {
    MechmlModel model = MechmlReader.read(fileName, content);
    return new LoadedModel(
        fileName,
        content,
        ReadOptions.NONE,
        sha256(content),
        new String(content, StandardCharsets.UTF_8),
        model,
        UserClasses.admit(model.mechanism(), userFiles, compile));
  }

  /**
   * Reads the file anew with other options.
   *
   * @throws MechmlException if they do not fit it, or it cannot be used with them
   */
  LoadedModel with(ReadOptions other) throws MechmlException {
    return other.equals(options)
        ? this
        : new LoadedModel(
            fileName,
            content,
            other,
            sha256,
            text,
            MechmlReader.read(fileName, content, other),
            userClasses);
  }

  /** Returns what its author should know before it runs: the reader's warnings, the scene's. */
  List<Diagnostic> warnings() {
    return SceneWarnings.of(model);
  }

  private static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
