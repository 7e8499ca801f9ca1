package org.mechservice.sim.service;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.MechmlReader;

/**
 * A model file as a session holds it.
 *
 * @param fileName its name, for messages
 * @param sha256 SHA-256 of its bytes, lower-case hexadecimal
 * @param text its bytes as UTF-8, for people to look at
 * @param model what it says
 */
record LoadedModel(String fileName, String sha256, String text, MechmlModel model) {

  /**
   * Reads a model file.
   *
   * @throws MechmlException if it cannot be used
   */
  static LoadedModel read(String fileName, byte[] content) throws MechmlException {
    return new LoadedModel(
        fileName,
        sha256(content),
        new String(content, StandardCharsets.UTF_8),
        MechmlReader.read(fileName, content));
  }

  private static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
