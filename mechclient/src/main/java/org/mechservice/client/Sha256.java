package org.mechservice.client;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.regex.Pattern;
import org.mechservice.solver.catalogue.MessageCode;

/** SHA-256 hashes as the service writes them: 64 lower-case hexadecimal digits. */
final class Sha256 {
  private static final Pattern FORM = Pattern.compile("[0-9a-f]{64}");

  private Sha256() {}

  static String of(byte[] bytes) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }

  static boolean isHash(String text) {
    return FORM.matcher(text).matches();
  }

  /**
   * Returns the bytes if they have the hash announced.
   *
   * @throws JarRefusedException if they do not
   */
  static byte[] verified(byte[] bytes, String announced, String what) {
    String found = of(bytes);
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
