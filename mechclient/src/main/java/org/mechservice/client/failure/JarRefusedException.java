package org.mechservice.client.failure;

/**
 * A JAR that came from the server is not the one it announced, or does not fit this client; nothing
 * of it was loaded.
 */
public final class JarRefusedException extends ServiceException {
  private static final long serialVersionUID = 1L;

  public JarRefusedException(String code, String text) {
    super(code, coded(code, text));
  }
}
