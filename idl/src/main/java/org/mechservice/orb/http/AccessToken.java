package org.mechservice.orb.http;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;

/** A secret that opens a page. */
public final class AccessToken {
  private static final int BYTES = 24;
  private static final SecureRandom RANDOM = new SecureRandom();

  private AccessToken() {}

  /** Makes a token from a secure random generator. */
  public static String random() {
    byte[] bytes = new byte[BYTES];
    RANDOM.nextBytes(bytes);
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }

  /**
   * Returns whether a token is the secret; takes as long whether the first or the last character
   * differs.
   */
  public static boolean isSame(String token, String secret) {
    return MessageDigest.isEqual(
        token.getBytes(StandardCharsets.UTF_8), secret.getBytes(StandardCharsets.UTF_8));
  }
}
