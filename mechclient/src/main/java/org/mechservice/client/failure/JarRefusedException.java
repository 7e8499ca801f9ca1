package org.mechservice.client.failure;

/**
 * A JAR from the server is not the announced one, or does not fit this client; no class of it was
 * loaded.
 */
public final class JarRefusedException extends ServiceException {
  private static final long serialVersionUID = 1L;

  public JarRefusedException(String code, String text) {
    super(code, coded(code, text));
  }
}
