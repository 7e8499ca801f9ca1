package org.mechservice.orb;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.mechservice.orb.connection.Endpoint;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The address of a server, as a user writes it: {@code host:port}, {@code host}, {@code
 * corbaloc:iiop:1.2@host:port/MechServer}, the same with {@code ssliop} over TLS, {@code
 * corbaname:iiop:1.2@host:port#MechServer}, {@code IOR:...}, or the name of a file that holds one
 * of these.
 */
final class ServiceUrl {
  /** The port of a server that names none. */
  static final int DEFAULT_PORT = 15000;

  private static final Pattern CORBALOC =
      Pattern.compile(
          "corbaloc:(iiop|ssliop|):(?:1\\.[012]@)?(\\[[0-9a-fA-F:]+]|[^:/@\\[\\]]+)(?::(\\d+))?(?:/.*)?");
  private static final Pattern SHORT =
      Pattern.compile("(\\[[0-9a-fA-F:]+]|[A-Za-z0-9._-]+)(?::(\\d{1,5}))?");
  private static final Pattern CORBANAME =
      Pattern.compile(
          "corbaname:(?:iiop)?:(?:1\\.[012]@)?(\\[[0-9a-fA-F:]+]|[^:/@#\\[\\]]+)(?::(\\d+))?"
              + "(?:/NameService)?#(.+)");

  /** The port of a naming service that names none, by the CORBA specification. */
  private static final int NAMING_PORT = 2809;

  private static final int LONGEST_IOR_FILE = 65536;

  private final String written;
  private final String stringified;
  private final String host;
  private final int port;
  private final String name;
  private final Scheme scheme;

  /** The encryption that a URL requires. */
  private enum Scheme {
    PLAIN,
    ENCRYPTED,
    LEFT_OPEN
  }

  private ServiceUrl(
      String written, String stringified, String host, int port, String name, Scheme scheme) {
    this.scheme = scheme;
    this.written = written;
    this.stringified = stringified;
    this.host = host;
    this.port = port;
    this.name = name;
  }

  /**
   * Reads a URL.
   *
   * @throws IllegalArgumentException with code S-006 if it is none of the known forms
   */
  static ServiceUrl parse(String written) {
    String text = written.strip();
    Matcher corbaloc = CORBALOC.matcher(text);
    if (corbaloc.matches()) {
      Scheme scheme = corbaloc.group(1).equals("ssliop") ? Scheme.ENCRYPTED : Scheme.PLAIN;
      return at(written, corbaloc, 2, DEFAULT_PORT, "", scheme);
    }
    Matcher corbaname = CORBANAME.matcher(text);
    if (corbaname.matches()) {
      return at(written, corbaname, 1, NAMING_PORT, corbaname.group(3), Scheme.LEFT_OPEN);
    }
    if (text.startsWith("IOR:")) {
      return new ServiceUrl(written, text, "", 0, "", Scheme.LEFT_OPEN);
    }
    String inFile = contentOfFile(text);
    if (!inFile.isEmpty()) {
      return parse(inFile);
    }
    Matcher shorthand = SHORT.matcher(text);
    if (shorthand.matches()) {
      return at(written, shorthand, 1, DEFAULT_PORT, "", Scheme.LEFT_OPEN);
    }
    throw notAUrl(written, null);
  }

  /**
   * @param first group of the host; that of the port follows
   */
  private static ServiceUrl at(
      String written, Matcher address, int first, int defaultPort, String name, Scheme scheme) {
    try {
      String given = address.group(first + 1);
      int port = given == null ? defaultPort : Integer.parseInt(given);
      if (port < 1 || port > 65535) {
        throw notAUrl(written, null);
      }
      return new ServiceUrl(written, "", address.group(first), port, name, scheme);
    } catch (NumberFormatException e) {
      throw notAUrl(written, e);
    }
  }

  private static String contentOfFile(String text) {
    try {
      Path file = text.startsWith("file:") ? Path.of(URI.create(text)) : Path.of(text);
      if (!Files.isRegularFile(file) || Files.size(file) > LONGEST_IOR_FILE) {
        return "";
      }
      String content = Files.readString(file, StandardCharsets.US_ASCII).strip();
      return content.startsWith("IOR:") || content.startsWith("corba") ? content : "";
    } catch (InvalidPathException | IOException e) {
      return "";
    } catch (IllegalArgumentException e) {
      throw notAUrl(text, e);
    }
  }

  private static IllegalArgumentException notAUrl(String written, @Nullable Throwable cause) {
    return new IllegalArgumentException(
        MessageCode.SERVER_ADDRESS
            + " \""
            + written
            + "\" is not the address of a server; write HOST:PORT,"
            + " corbaloc:iiop:1.2@HOST:PORT/MechServer, corbaname:iiop:1.2@HOST:PORT#MechServer,"
            + " or the name of an IOR file",
        cause);
  }

  /** Returns the URL of one of the server's objects at an endpoint. */
  static String corbaloc(Endpoint endpoint, ServiceKey key, boolean encrypted) {
    return (encrypted ? "corbaloc:ssliop:1.2@" : "corbaloc:iiop:1.2@") + endpoint + "/" + key.key();
  }

  /**
   * Makes sure that the URL requires the encryption that the process uses.
   *
   * @throws IllegalArgumentException with code S-151 if it is not
   */
  void requireFits(boolean encrypted) {
    if (scheme == Scheme.ENCRYPTED && !encrypted) {
      throw new IllegalArgumentException(
          MessageCode.TLS_MISMATCH
              + " "
              + written
              + " is encrypted, and this process has no certificate; give it one"
              + " with --tls FOLDER");
    } else if (scheme == Scheme.PLAIN && encrypted) {
      throw new IllegalArgumentException(
          MessageCode.TLS_MISMATCH
              + " "
              + written
              + " is not encrypted, and this process has been told to use TLS; write"
              + " HOST:PORT or corbaloc:ssliop:1.2@HOST:PORT/MechServer, or leave --tls out");
    }
  }

  /** Returns whether this is a stringified reference, whose address only an ORB can read. */
  boolean isReference() {
    return !stringified.isEmpty();
  }

  /** Returns whether this is a name at a naming service, whose address it has. */
  boolean isName() {
    return !name.isEmpty();
  }

  /** Returns the name at the naming service; empty if this is an address. */
  String name() {
    return name;
  }

  /** Returns the stringified reference; empty if this is an address. */
  String reference() {
    return stringified;
  }

  /** Returns the host; empty if this is a stringified reference. */
  String host() {
    return host;
  }

  /** Returns the port; 0 if this is a stringified reference. */
  int port() {
    return port;
  }

  /** Returns the URL as messages show it. */
  @Override
  public String toString() {
    return isReference() ? written : host + ":" + port;
  }
}
