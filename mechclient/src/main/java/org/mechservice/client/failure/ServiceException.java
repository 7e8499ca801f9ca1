package org.mechservice.client.failure;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The service refused a call, or could not be reached. Every case has a stable code and one
 * message; the hierarchy is sealed, so a {@code switch} over it is complete.
 */
public abstract sealed class ServiceException extends RuntimeException
    permits InvalidModelException,
        InvalidOptionException,
        InvalidStateException,
        JarRefusedException,
        LimitExceededException,
        NotAuthorizedException,
        NotAvailableException,
        NotFoundException,
        ServerFailureException,
        ServerLostException {
  private static final long serialVersionUID = 1L;

  private static final Pattern LEADING_CODE = Pattern.compile("^[MNS]-\\d{3}\\b");

  private final String code;

  ServiceException(String code, String message) {
    super(message);
    this.code = code;
  }

  /** Returns the text as a message that begins with its code. */
  static String coded(String code, String text) {
    return text.startsWith(code) ? text : code + " " + text;
  }

  /** Returns the code a message begins with, or another one if it has none. */
  public static String codeOf(String message, String otherwise) {
    Matcher coded = LEADING_CODE.matcher(message);
    return coded.find() ? coded.group() : otherwise;
  }

  /** Returns the entry of the error catalogue, such as {@code S-031}. */
  public final String code() {
    return code;
  }
}
