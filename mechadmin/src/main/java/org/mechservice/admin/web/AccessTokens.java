package org.mechservice.admin.web;

import java.io.IOException;
import java.io.Reader;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Properties;
import org.mechservice.orb.http.AccessToken;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The access tokens of the page: one for reading, one for actions. They travel in a header that no
 * other site can make a browser send, never in a cookie or in the address of a request.
 *
 * @param monitor lets its bearer see everything
 * @param admin lets its bearer do everything
 */
public record AccessTokens(String monitor, String admin) {
  private static final int SHORTEST = 16;
  private static final String MONITOR = "monitor";
  private static final String ADMIN = "admin";

  /**
   * @throws IllegalArgumentException with code S-136 if they can be guessed, or are equal
   */
  public AccessTokens {
    if (monitor.length() < SHORTEST || admin.length() < SHORTEST || monitor.equals(admin)) {
      throw new IllegalArgumentException(
          MessageCode.TOKENS_UNUSABLE
              + " the tokens monitor and admin must differ and have "
              + SHORTEST
              + " characters or more each");
    }
  }

  /** Makes tokens from a secure random generator. */
  public static AccessTokens random() {
    return new AccessTokens(AccessToken.random(), AccessToken.random());
  }

  /**
   * Returns the tokens in a file; makes the file, readable by its owner alone, if there is none.
   *
   * @throws IOException if the file cannot be read or made
   * @throws IllegalArgumentException with code S-136 if it holds no tokens
   */
  public static AccessTokens kept(Path file) throws IOException {
    if (!Files.exists(file)) {
      AccessTokens made = random();
      made.write(file);
      return made;
    }
    Properties properties = new Properties();
    try (Reader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      properties.load(in);
    }
    return new AccessTokens(properties.getProperty(MONITOR, ""), properties.getProperty(ADMIN, ""));
  }

  private void write(Path file) throws IOException {
    Properties properties = new Properties();
    properties.setProperty(MONITOR, monitor);
    properties.setProperty(ADMIN, admin);
    StringWriter text = new StringWriter();
    properties.store(text, "who has these may see, or steer, the servers of mech admin web");
    if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      Files.createFile(
          file, PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
    }
    try (Writer out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
      out.write(text.toString());
    }
  }

  /** Returns the right of a token. */
  Right rightOf(String token) {
    if (AccessToken.isSame(token, admin)) {
      return Right.ADMIN;
    }
    return AccessToken.isSame(token, monitor) ? Right.MONITOR : Right.NONE;
  }

  /** Returns no secrets. */
  @Override
  public String toString() {
    return "AccessTokens";
  }
}
